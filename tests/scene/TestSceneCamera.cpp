#include "apps/scene/SceneCamera.h"

#include <gtest/gtest.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSwellSeafloorReader.h>

#include <cmath>
#include <string>

using namespace swellray::scene;

namespace
{

// A beach of 1 in 50 that faces west: land east of x = 0.
class Beach
{
public:
  explicit Beach(const std::string& form = "plane:facing=270,slope=0.02")
  {
    this->Reader->SetFileName(form.c_str());
    this->Reader->Update();
  }

  SceneCamera camera(CameraName name, double directionFrom = 270.0, double waterLevel = 0.0) const
  {
    return cameraByName(name, { this->Reader->GetOutput(), waterLevel, directionFrom, 2.0 });
  }

  vtkImageData* seafloor() const { return this->Reader->GetOutput(); }

private:
  vtkNew<vtkSwellSeafloorReader> Reader;
};

}

TEST(SceneCamera, ShoreIsOnDrySandAndLooksTowardsTheWaves)
{
  const Beach beach;
  for (const double level : { 0.0, 1.0 })
  {
    const SceneCamera camera = beach.camera(CameraName::Shore, 270.0, level);
    const double ground = 0.02 * camera.eye[0]; // elevation there
    EXPECT_GT(ground, level);
    EXPECT_LT(ground, level + 2.0);            // and near to the water
    EXPECT_GT(camera.eye[2], ground + 1.7);    // the eye of somebody who stands
    EXPECT_LT(camera.focus[0], camera.eye[0]); // westwards
    EXPECT_LT(camera.focus[2], camera.eye[2]);
    const double aside = std::atan2(camera.focus[1] - camera.eye[1], camera.eye[0] - camera.focus[0]);
    EXPECT_LT(std::abs(aside), 0.5);
  }
}

TEST(SceneCamera, AerialLooksOverTheShoreOutToSea)
{
  const SceneCamera camera = Beach().camera(CameraName::Aerial);
  EXPECT_GT(camera.eye[0], 0.0);
  EXPECT_GT(camera.eye[2], 500.0); // the scene is 2.5 km wide
  EXPECT_LT(camera.focus[0], camera.eye[0]);
}

TEST(SceneCamera, AerialBeginsOnLandOfTheScene)
{
  // Babbage beach is 500 m along the shore, in the south, and less across.
  const Beach babbage("babbage");
  const SceneCamera camera = babbage.camera(CameraName::Aerial, 0.0);
  const double slant = std::atan2(camera.eye[2] - camera.focus[2], camera.focus[1] - camera.eye[1]);
  const double lower = slant + 0.5 * camera.angle * 3.14159265358979 / 180.0;
  double bounds[6];
  babbage.seafloor()->GetBounds(bounds);
  EXPECT_GT(camera.eye[1] + camera.eye[2] / std::tan(lower), bounds[2]);
  EXPECT_LT(camera.eye[1], bounds[2]); // from where nothing is drawn
}

TEST(SceneCamera, ChartSeesAllOfTheSceneFromAbove)
{
  const SceneCamera camera = Beach().camera(CameraName::Chart);
  EXPECT_EQ(camera.eye[0], camera.focus[0]);
  EXPECT_EQ(camera.eye[1], camera.focus[1]);
  EXPECT_EQ(camera.up[1], 1.0); // north
  // Half of the picture is more than half of the scene, 1250 m.
  const double half = std::tan(0.5 * camera.angle * 3.14159265358979 / 180.0) * camera.eye[2];
  EXPECT_GT(half, 1250.0);
  EXPECT_LT(half, 1500.0);
}

TEST(SceneCamera, FindsAPlaceWithoutLand)
{
  // All water, and waves that go along the shore: the place is where they leave the scene.
  const SceneCamera sea = Beach("shoal:kind=gauss").camera(CameraName::Shore);
  const SceneCamera along = Beach().camera(CameraName::Shore, 0.0);
  for (const SceneCamera& camera : { sea, along })
  {
    EXPECT_TRUE(std::isfinite(camera.eye[0]) && std::isfinite(camera.eye[1]));
    EXPECT_GT(camera.eye[2], 1.0);
  }
}
