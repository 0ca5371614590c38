#pragma once

#include <array>
#include <optional>
#include <string>

class vtkImageData;

namespace swellray::scene
{

/** Where a picture is taken from, m. */
struct SceneCamera
{
  std::array<double, 3> eye{ 0.0, 0.0, 1.0 };
  std::array<double, 3> focus{ 0.0, 0.0, 0.0 };
  std::array<double, 3> up{ 0.0, 0.0, 1.0 };
  double angle = 40.0; ///< of view, upwards, degrees
};

/** Names of cameras. */
enum class CameraName
{
  Shore,  ///< at the eye of somebody on the beach, towards the waves
  Aerial, ///< from the land, high over the shore
  Chart,  ///< straight down, north up
};

/** What a camera by name needs to know. */
struct CameraScene
{
  vtkImageData* seafloor = nullptr; ///< point array Elevation, m
  double waterLevel = 0.0;          ///< m
  double directionFrom = 270.0;     ///< of the waves, nautical degrees
  double height = 1.0;              ///< of the waves, m
};

/**
 * A camera by name. On a seafloor without land the shore is where the waves leave it.
 */
SceneCamera cameraByName(CameraName name, const CameraScene& scene);

}
