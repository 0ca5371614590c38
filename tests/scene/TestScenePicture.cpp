#include "apps/drawing/VirtualDisplay.h"
#include "apps/scene/ScenePicture.h"

#include <gtest/gtest.h>

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSwellFoam.h>
#include <vtkSwellRayTracer.h>
#include <vtkSwellSeafloorReader.h>
#include <vtkSwellSurface.h>
#include <vtkSwellWaveHeight.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>

using namespace swellray::scene;

namespace
{

constexpr int Width = 240;
constexpr int Height = 160;

/** The bay from above, with its sea. */
class ScenePictureTest : public testing::Test
{
protected:
  void SetUp() override
  {
    if (std::getenv("ASAN_OPTIONS") || std::getenv("TSAN_OPTIONS"))
    {
      GTEST_SKIP() << "sanitizers see into the software driver of OpenGL";
    }
    try
    {
      this->Display.emplace();
    }
    catch (const std::runtime_error& error)
    {
      GTEST_SKIP() << error.what();
    }
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
  }

  std::unique_ptr<ScenePicture> makePicture(CameraName name)
  {
    SceneContent content;
    content.seafloor = this->Reader->GetOutput();
    content.waveHeight = 0.4;
    content.wavelength = 14.0;
    content.directionFrom = 90.0;
    content.camera = cameraByName(name, { this->Reader->GetOutput(), 0.0, 90.0, 0.4 });
    content.sky = SkyModel(145.0, 35.0);
    content.width = Width;
    content.height = Height;
    return std::make_unique<ScenePicture>(content);
  }

  // The sea with as much foam everywhere.
  vtkSmartPointer<vtkPolyData> seaWithFoam(float share)
  {
    auto sea = vtkSmartPointer<vtkPolyData>::New();
    sea->ShallowCopy(this->Foam->GetOutput());
    vtkNew<vtkFloatArray> foam;
    foam->SetName("Foam");
    foam->SetNumberOfTuples(sea->GetNumberOfPoints());
    foam->Fill(share);
    sea->GetPointData()->AddArray(foam);
    return sea;
  }

  std::optional<swellray::drawing::VirtualDisplay> Display;
  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellRayTracer> Tracer;
  vtkNew<vtkSwellWaveHeight> Heights;
  vtkNew<vtkSwellSurface> Surface;
  vtkNew<vtkSwellFoam> Foam;
};

// Mean colour of a part of a picture, 0 to 255; shares of its width and height.
std::array<double, 3> mean(vtkImageData* picture, double left, double right, double bottom, double top)
{
  std::array<double, 3> sum{};
  int count = 0;
  for (int y = static_cast<int>(bottom * Height); y < static_cast<int>(top * Height); ++y)
  {
    for (int x = static_cast<int>(left * Width); x < static_cast<int>(right * Width); ++x)
    {
      const auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0));
      for (std::size_t i = 0; i < 3; ++i)
      {
        sum[i] += pixel[i];
      }
      ++count;
    }
  }
  for (double& value : sum)
  {
    value /= count;
  }
  return sum;
}

int differences(vtkImageData* a, vtkImageData* b)
{
  int count = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const auto* p = static_cast<unsigned char*>(a->GetScalarPointer(x, y, 0));
      const auto* q = static_cast<unsigned char*>(b->GetScalarPointer(x, y, 0));
      count += std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]) > 8 ? 1 : 0;
    }
  }
  return count;
}

}

TEST_F(ScenePictureTest, SeaIsBlueAndSandIsNot)
{
  const auto picture = this->makePicture(CameraName::Chart)->draw(this->Foam->GetOutput(), 0.0);
  ASSERT_EQ(picture->GetDimensions()[0], Width);
  ASSERT_EQ(picture->GetDimensions()[1], Height);
  ASSERT_EQ(picture->GetNumberOfScalarComponents(), 3);
  // The scene is as high as the picture: from 0.17 to 0.83 of its width; the sea is east, the land west.
  const auto sea = mean(picture, 0.65, 0.8, 0.2, 0.8);
  const auto land = mean(picture, 0.2, 0.3, 0.2, 0.8);
  EXPECT_GT(sea[2], sea[0] + 20.0);
  EXPECT_GT(land[0], land[2] + 5.0);
}

TEST_F(ScenePictureTest, SkyIsOverTheSea)
{
  const auto picture = this->makePicture(CameraName::Shore)->draw(this->Foam->GetOutput(), 0.0);
  const auto sky = mean(picture, 0.0, 1.0, 0.9, 1.0);
  EXPECT_GT(sky[2], 100.0);
  EXPECT_GT(sky[2], sky[0]); // blue away from the sun
}

TEST_F(ScenePictureTest, FoamIsWhite)
{
  const auto picture = this->makePicture(CameraName::Chart);
  const auto without = mean(picture->draw(this->seaWithFoam(0.0F), 0.0), 0.6, 0.8, 0.2, 0.8);
  const auto half = mean(picture->draw(this->seaWithFoam(0.6F), 0.0), 0.6, 0.8, 0.2, 0.8);
  const auto full = mean(picture->draw(this->seaWithFoam(1.0F), 0.0), 0.6, 0.8, 0.2, 0.8);
  EXPECT_GT(half[0], without[0] + 10.0);
  EXPECT_GT(full[0], half[0] + 20.0);
  EXPECT_LT(full[2] - full[0], 30.0); // hardly any colour
}

TEST_F(ScenePictureTest, FramesDependOnTheirTimeAlone)
{
  const auto picture = this->makePicture(CameraName::Aerial);
  const auto first = picture->draw(this->Foam->GetOutput(), 0.0);
  this->Surface->SetTime(1.0);
  this->Foam->Update();
  const auto later = picture->draw(this->Foam->GetOutput(), 1.0);
  EXPECT_GT(differences(first, later), Width * Height / 20);
  this->Surface->SetTime(0.0);
  this->Foam->Update();
  const auto again = picture->draw(this->Foam->GetOutput(), 0.0);
  EXPECT_EQ(differences(first, again), 0);
}

TEST_F(ScenePictureTest, SprayIsSeenOverTheSea)
{
  const auto picture = this->makePicture(CameraName::Chart);
  // A cloud of droplets over deep water in the east.
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> velocity;
  velocity->SetName("Velocity");
  velocity->SetNumberOfComponents(3);
  for (int i = 0; i < 2000; ++i)
  {
    points->InsertNextPoint(42.0 + 0.1 * (i % 50), -2.0 + 0.1 * (i / 50), 1.0);
    velocity->InsertNextTuple3(-2.0 - 1e-4 * i, 0.0, 1.0);
  }
  vtkNew<vtkPolyData> spray;
  spray->SetPoints(points);
  spray->GetPointData()->AddArray(velocity);
  const auto without = picture->draw(this->Foam->GetOutput(), 0.0);
  const auto with = picture->draw(this->Foam->GetOutput(), 0.0, spray);
  // The scene is 100 m, as the picture is high, and the cloud 5 m by 4 m.
  const int cloud = differences(without, with);
  EXPECT_GT(cloud, 0.3 * 20.0 * Height * Height / 1e4);
  EXPECT_LT(cloud, 4.0 * 20.0 * Height * Height / 1e4);
  EXPECT_GT(mean(with, 0.67, 0.70, 0.48, 0.52)[0], mean(without, 0.67, 0.70, 0.48, 0.52)[0] + 10.0);
  EXPECT_EQ(differences(without, picture->draw(this->Foam->GetOutput(), 0.0)), 0);
}
