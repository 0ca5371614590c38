#include "apps/drawing/Relief.h"
#include "apps/scene/GltfScene.h"
#include "apps/scene/SceneColors.h"

#include <gtest/gtest.h>

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkFloatArray.h>
#include <vtkGLTFImporter.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSwellFoam.h>
#include <vtkSwellRayTracer.h>
#include <vtkSwellSeafloorReader.h>
#include <vtkSwellSurface.h>
#include <vtkSwellWaveHeight.h>

#include <cmath>
#include <stdexcept>

using namespace swellray::scene;

namespace
{

// Places are floats in the file.
constexpr double Float = 1e-5;

// Colours are bytes in the file.
constexpr double Byte = 0.5 / 255.0 + 1e-6;

/** The bay with its sea, written and read again. */
class GltfSceneTest : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Reader->SetFileName("bay");
    this->Tracer->SetInputConnection(this->Reader->GetOutputPort());
    this->Tracer->SetPeriod(3.0);
    this->Tracer->SetDirectionFrom(90.0);
    this->Tracer->SetWaveHeight(0.4);
    this->Heights->SetInputConnection(this->Tracer->GetOutputPort());
    this->Surface->SetInputConnection(0, this->Heights->GetOutputPort());
    this->Surface->SetSeafloorConnection(this->Reader->GetOutputPort());
    this->Foam->SetInputConnection(this->Surface->GetOutputPort());
    this->Foam->Update();
    this->Content.seafloor = this->Reader->GetOutput();
    this->Content.waveHeight = 0.4;
    this->Content.directionFrom = 90.0;
    this->Content.camera = cameraByName(CameraName::Aerial, { this->Reader->GetOutput(), 0.0, 90.0, 0.4 });
  }

  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellRayTracer> Tracer;
  vtkNew<vtkSwellWaveHeight> Heights;
  vtkNew<vtkSwellSurface> Surface;
  vtkNew<vtkSwellFoam> Foam;
  SceneContent Content;
};

}

TEST_F(GltfSceneTest, IsReadAgainWithItsColors)
{
  const std::string path = testing::TempDir() + "swellray_scene.gltf";
  writeGltf(this->Content, this->Foam->GetOutput(), "the bay", path);

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  vtkNew<vtkGLTFImporter> importer;
  importer->SetFileName(path.c_str());
  importer->SetRenderWindow(window);
  importer->Update();
  vtkActorCollection* actors = importer->GetRenderer()->GetActors();
  ASSERT_EQ(actors->GetNumberOfItems(), 2);

  vtkPolyData* sea = this->Foam->GetOutput();
  const vtkIdType seaPoints = sea->GetNumberOfPoints();
  vtkDataArray* foam = sea->GetPointData()->GetArray("Foam");
  vtkDataArray* normals = sea->GetPointData()->GetArray("Normals");
  const SceneColors colors(this->Content.seafloor, 0.0);
  actors->InitTraversal();
  int seas = 0;
  for (int k = 0; k < 2; ++k)
  {
    auto* data = vtkPolyData::SafeDownCast(actors->GetNextActor()->GetMapper()->GetInput());
    ASSERT_NE(data, nullptr);
    auto* color = data->GetPointData()->GetArray("COLOR_0");
    auto* normal = data->GetPointData()->GetArray("NORMAL");
    ASSERT_NE(color, nullptr);
    ASSERT_NE(normal, nullptr);
    ASSERT_EQ(color->GetNumberOfComponents(), 4);
    const bool isSea = data->GetNumberOfPoints() == seaPoints;
    seas += isSea ? 1 : 0;
    ASSERT_GT(data->GetNumberOfCells(), isSea ? sea->GetNumberOfCells() - 1 : 100000);
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); i += 97)
    {
      double p[3];
      data->GetPoint(i, p);
      swellray::drawing::Rgb expected;
      if (isSea)
      {
        double q[3];
        sea->GetPoint(i, q);
        // x east, y up, z south.
        EXPECT_NEAR(p[0], q[0], Float);
        EXPECT_NEAR(p[1], q[2], Float);
        EXPECT_NEAR(p[2], -q[1], Float);
        EXPECT_NEAR(normal->GetComponent(i, 1), normals->GetComponent(i, 2), Float);
        EXPECT_NEAR(color->GetComponent(i, 3), SceneColors::WaterOpacity, Byte);
        expected = SceneColors::water(foam->GetComponent(i, 0));
      }
      else
      {
        EXPECT_EQ(color->GetComponent(i, 3), 1.0);
        expected = colors.bed(p[1]);
      }
      for (int j = 0; j < 3; ++j)
      {
        EXPECT_NEAR(color->GetComponent(i, j), expected[static_cast<std::size_t>(j)], Byte);
      }
    }
  }
  EXPECT_EQ(seas, 1);
}

TEST_F(GltfSceneTest, SaysThatAFileCannotBeWritten)
{
  EXPECT_THROW(writeGltf(this->Content, this->Foam->GetOutput(), "", "/nowhere/scene.gltf"), std::runtime_error);
}

TEST(SceneColors, FollowDepthAndFoam)
{
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName("bay");
  reader->Update();
  const SceneColors colors(reader->GetOutput(), 0.0);
  EXPECT_GT(colors.bed(-0.1)[1], colors.bed(-5.0)[1]); // deeper is darker
  EXPECT_GT(colors.bed(-1.0)[2], colors.bed(-1.0)[0]); // and blue
  EXPECT_GT(colors.bed(1.0)[0], colors.bed(1.0)[2]);   // land is not
  EXPECT_GT(SceneColors::water(1.0)[0], 0.9);          // foam is white
  EXPECT_LT(SceneColors::water(0.0)[0], SceneColors::water(0.5)[0]);
}
