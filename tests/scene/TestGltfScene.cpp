#include "apps/drawing/Relief.h"
#include "apps/scene/GltfScene.h"
#include "apps/scene/RayLines.h"
#include "apps/scene/SceneColors.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkBase64Utilities.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkGLTFImporter.h>
#include <vtkImageData.h>
#include <vtkLine.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSwellFoam.h>
#include <vtkSwellRayTracer.h>
#include <vtkSwellSeafloorReader.h>
#include <vtkSwellSpray.h>
#include <vtkSwellSurface.h>
#include <vtkSwellWaveHeight.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

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
  GltfScene scene(this->Content, "the bay", 3.0);
  scene.add(this->Foam->GetOutput(), 0.0);
  scene.write(path);

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
  GltfScene scene(this->Content, "", 3.0);
  scene.add(this->Foam->GetOutput(), 0.0);
  EXPECT_THROW(scene.write("/nowhere/scene.gltf"), std::runtime_error);
}

namespace
{

// Numbers of an accessor, decoded from the buffer within the file.
std::vector<float> numbersOf(const nlohmann::json& gltf, std::size_t accessor)
{
  const auto& view = gltf["bufferViews"][gltf["accessors"][accessor]["bufferView"].get<std::size_t>()];
  const auto uri = gltf["buffers"][view["buffer"].get<std::size_t>()]["uri"].get<std::string>();
  const std::string text = uri.substr(uri.find(',') + 1);
  std::vector<unsigned char> bytes(text.size());
  const std::size_t length = vtkBase64Utilities::DecodeSafely(
    reinterpret_cast<const unsigned char*>(text.data()), text.size(), bytes.data(), bytes.size());
  const auto first = view["byteOffset"].get<std::size_t>();
  const auto size = view["byteLength"].get<std::size_t>();
  EXPECT_LE(first + size, length);
  std::vector<float> numbers(size / sizeof(float));
  std::memcpy(numbers.data(), bytes.data() + first, size);
  return numbers;
}

}

TEST_F(GltfSceneTest, MovesAsItsTimesDo)
{
  const std::string path = testing::TempDir() + "swellray_motion.gltf";
  constexpr double Period = 3.0;
  constexpr int Times = 4; // of a whole period
  vtkNew<vtkSwellSpray> spray;
  spray->SetInputConnection(0, this->Heights->GetOutputPort());
  spray->SetSeafloorConnection(this->Reader->GetOutputPort());
  spray->SetRate(100.0);
  GltfScene scene(this->Content, "the bay", Period);
  scene.setRays(this->Heights->GetOutput());
  std::vector<vtkSmartPointer<vtkPolyData>> seas;
  std::vector<vtkIdType> drops;
  for (int i = 0; i < Times; ++i)
  {
    const double time = 10.0 + Period * i / Times;
    this->Surface->SetTime(time);
    this->Foam->Update();
    spray->SetTime(time);
    spray->Update();
    seas.push_back(vtkSmartPointer<vtkPolyData>::New());
    seas.back()->DeepCopy(this->Foam->GetOutput());
    drops.push_back(spray->GetOutput()->GetNumberOfPoints());
    scene.add(this->Foam->GetOutput(), time, spray->GetOutput());
  }
  scene.write(path);
  nlohmann::json gltf;
  std::ifstream(path) >> gltf;

  ASSERT_EQ(gltf["meshes"].size(), 3u + Times);
  EXPECT_EQ(gltf["meshes"][2]["name"], "rays");
  EXPECT_EQ(gltf["meshes"][2]["primitives"][0]["mode"], 1); // lines
  for (std::size_t i = 0; i < Times; ++i)
  {
    const auto& mesh = gltf["meshes"][3 + i];
    EXPECT_EQ(mesh["name"], "spray");
    EXPECT_EQ(mesh["primitives"][0]["mode"], 0); // points
    EXPECT_EQ(gltf["accessors"][mesh["primitives"][0]["attributes"]["POSITION"].get<std::size_t>()]["count"], drops[i]);
  }

  // First place and change are those of the surface at each time.
  const auto& sea = gltf["meshes"][1]["primitives"][0];
  const std::vector<float> first = numbersOf(gltf, sea["attributes"]["POSITION"].get<std::size_t>());
  ASSERT_EQ(sea["targets"].size(), Times - 1u);
  double moved = 0.0;
  for (std::size_t k = 1; k < Times; ++k)
  {
    const std::vector<float> by = numbersOf(gltf, sea["targets"][k - 1]["POSITION"].get<std::size_t>());
    const std::vector<float> turn = numbersOf(gltf, sea["targets"][k - 1]["NORMAL"].get<std::size_t>());
    const std::vector<float> up = numbersOf(gltf, sea["attributes"]["NORMAL"].get<std::size_t>());
    ASSERT_EQ(by.size(), first.size());
    for (std::size_t i = 0; i < by.size() / 3; i += 31)
    {
      double p[3];
      seas[k]->GetPoint(static_cast<vtkIdType>(i), p);
      EXPECT_NEAR(first[3 * i] + by[3 * i], p[0], Float);
      EXPECT_NEAR(first[3 * i + 1] + by[3 * i + 1], p[2], Float);
      EXPECT_NEAR(first[3 * i + 2] + by[3 * i + 2], -p[1], Float);
      seas[k]->GetPointData()->GetArray("Normals")->GetTuple(static_cast<vtkIdType>(i), p);
      EXPECT_NEAR(up[3 * i + 1] + turn[3 * i + 1], p[2], Float);
      moved = std::max(moved, std::abs(static_cast<double>(by[3 * i + 1])));
    }
  }
  EXPECT_GT(moved, 0.2); // waves of 0.4 m

  // At the time of each its target alone has weight; the waves end where they began.
  const auto& animation = gltf["animations"][0];
  const auto& channel = animation["channels"][0];
  ASSERT_EQ(channel["target"]["path"], "weights");
  EXPECT_EQ(gltf["nodes"][channel["target"]["node"].get<std::size_t>()]["name"], "sea");
  const auto& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
  EXPECT_EQ(sampler["interpolation"], "LINEAR");
  const std::vector<float> clock = numbersOf(gltf, sampler["input"].get<std::size_t>());
  EXPECT_EQ(clock, (std::vector<float>{ 0.0f, 0.75f, 1.5f, 2.25f, 3.0f }));
  EXPECT_EQ(numbersOf(gltf, sampler["output"].get<std::size_t>()),
    (std::vector<float>{ 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0 }));

  // Spray has size from its time to the next.
  ASSERT_EQ(animation["channels"].size(), 1u + Times);
  const auto& second = animation["samplers"][animation["channels"][2]["sampler"].get<std::size_t>()];
  EXPECT_EQ(animation["channels"][2]["target"]["path"], "scale");
  EXPECT_EQ(second["interpolation"], "STEP");
  EXPECT_EQ(numbersOf(gltf, second["output"].get<std::size_t>()),
    (std::vector<float>{ 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0 }));
}

TEST_F(GltfSceneTest, RefusesAnotherSheet)
{
  GltfScene scene(this->Content, "", 3.0);
  scene.add(this->Foam->GetOutput(), 0.0);
  this->Surface->SetPointsPerWave(24.0);
  this->Foam->Update();
  EXPECT_THROW(scene.add(this->Foam->GetOutput(), 0.1), std::runtime_error);
}

TEST(RayLines, KeepTheirWayOverTheWater)
{
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName("bay");
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputConnection(reader->GetOutputPort());
  tracer->SetPeriod(3.0);
  tracer->SetDirectionFrom(90.0);
  tracer->SetWaveHeight(0.4);
  tracer->SetSpacing(0.2); // several times as many rays as are shown
  tracer->Update();
  vtkPolyData* rays = tracer->GetOutput();
  ASSERT_GT(rays->GetNumberOfLines(), MostRayLines);
  const auto lines = rayLines(rays, 0.7);
  EXPECT_LE(lines->GetNumberOfLines(), MostRayLines);
  EXPECT_GT(lines->GetNumberOfLines(), MostRayLines / 3);
  EXPECT_LT(lines->GetNumberOfPoints(), rays->GetNumberOfPoints() / 4);
  double bounds[6];
  rays->GetBounds(bounds);
  const double seen = std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]) / 1000.0;
  // No point of the first ray is further from its line than a pixel of the whole.
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  rays->GetLines()->GetCellAtId(0, count, ids);
  vtkIdType kept = 0;
  const vtkIdType* corners = nullptr;
  lines->GetLines()->GetCellAtId(0, kept, corners);
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    rays->GetPoint(ids[i], p);
    p[2] = 0.7;
    double nearest = 1e300;
    for (vtkIdType k = 0; k + 1 < kept; ++k)
    {
      double a[3];
      double b[3];
      double along = 0.0;
      lines->GetPoint(corners[k], a);
      lines->GetPoint(corners[k + 1], b);
      nearest = std::min(nearest, vtkLine::DistanceToLine(p, a, b, along, nullptr));
    }
    EXPECT_LT(std::sqrt(nearest), seen);
  }
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
