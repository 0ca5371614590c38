#include "SceneCamera.h"

#include "sim/Angles.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace swellray::scene
{

namespace
{

// Somebody on the beach sees from here, m, and over waves that are higher from a dune.
constexpr double EyeHeight = 1.8;
constexpr double EyeOverWaves = 3.0; // wave heights

// Over the run-up of the waves, wave heights.
constexpr double DryAbove = 0.25;

// Waves are seen from a little aside, and the horizon in the upper half.
constexpr double Aside = 22.0; // degrees
constexpr double Downwards = 0.13;

constexpr double AerialSlant = 28.0;  // degrees below the horizon
constexpr double AerialMargin = 0.05; // of the scene
constexpr double ShoreAngle = 34.0;   // of view, degrees

class Ground
{
public:
  explicit Ground(const CameraScene& scene)
    : Image(scene.seafloor)
    , Level(scene.waterLevel)
  {
    this->Image->GetBounds(this->Bounds);
  }

  double width() const { return this->Bounds[1] - this->Bounds[0]; }
  double length() const { return this->Bounds[3] - this->Bounds[2]; }
  std::array<double, 2> middle() const
  {
    return { 0.5 * (this->Bounds[0] + this->Bounds[1]), 0.5 * (this->Bounds[2] + this->Bounds[3]) };
  }

  bool holds(double x, double y) const
  {
    return x >= this->Bounds[0] && x <= this->Bounds[1] && y >= this->Bounds[2] && y <= this->Bounds[3];
  }

  // Height over the water of the nearest node; the water's where there is none.
  double height(double x, double y) const
  {
    const double* origin = this->Image->GetOrigin();
    const double* spacing = this->Image->GetSpacing();
    const int* size = this->Image->GetDimensions();
    const auto node = [&](double at, int axis)
    { return std::clamp(static_cast<int>(std::lround((at - origin[axis]) / spacing[axis])), 0, size[axis] - 1); };
    const double z = this->Image->GetPointData()
                       ->GetArray("Elevation")
                       ->GetComponent(static_cast<vtkIdType>(node(y, 1)) * size[0] + node(x, 0), 0);
    return std::isfinite(z) ? z - this->Level : 0.0;
  }

private:
  vtkImageData* Image;
  double Level;
  double Bounds[6];
};

// The place nearest to the middle, on the way of the waves through it, that stays dry; the last one where none does.
std::array<double, 2> dryPlace(const Ground& ground, const CameraScene& scene, double x, double y)
{
  const auto middle = ground.middle();
  const double step = 0.002 * std::max(ground.width(), ground.length());
  std::array<double, 2> place = middle;
  // Back to the water where the middle is land.
  double begin = 0.0;
  while (ground.height(middle[0] - begin * x, middle[1] - begin * y) > 0.0 &&
    ground.holds(middle[0] - begin * x, middle[1] - begin * y))
  {
    begin += step;
  }
  for (double way = -begin;; way += step)
  {
    const std::array<double, 2> at{ middle[0] + way * x, middle[1] + way * y };
    if (!ground.holds(at[0], at[1]))
    {
      return place;
    }
    place = at;
    if (ground.height(at[0], at[1]) > DryAbove * scene.height)
    {
      return place;
    }
  }
}

}

SceneCamera cameraByName(CameraName name, const CameraScene& scene)
{
  const Ground ground(scene);
  const auto middle = ground.middle();
  const double extent = std::max(ground.width(), ground.length());
  const double heading = headingFromNautical(scene.directionFrom);
  const double x = std::cos(heading);
  const double y = std::sin(heading);
  SceneCamera camera;
  if (name == CameraName::Chart)
  {
    camera.up = { 0.0, 1.0, 0.0 };
    const double away = 0.5 * extent / std::tan(radians(0.5 * camera.angle));
    camera.eye = { middle[0], middle[1], scene.waterLevel + 1.04 * away };
    camera.focus = { middle[0], middle[1], scene.waterLevel };
    return camera;
  }
  if (name == CameraName::Aerial)
  {
    const double away = 0.95 * extent;
    const double slant = radians(AerialSlant);
    // The land ends where the scene does: the lower edge of the picture is within it.
    const double lowest = away * (std::cos(slant) - std::sin(slant) / std::tan(slant + radians(0.5 * camera.angle)));
    const double within = 0.5 * (std::abs(x) * ground.width() + std::abs(y) * ground.length()) - AerialMargin * extent;
    const double forward = std::max(0.0, lowest - within);
    camera.focus = { middle[0] - forward * x, middle[1] - forward * y, scene.waterLevel };
    camera.eye = { camera.focus[0] + away * std::cos(slant) * x, camera.focus[1] + away * std::cos(slant) * y,
      scene.waterLevel + away * std::sin(slant) };
    return camera;
  }
  const auto shore = dryPlace(ground, scene, x, y);
  const double eye = std::max(EyeHeight, EyeOverWaves * scene.height);
  camera.angle = ShoreAngle;
  camera.eye = { shore[0], shore[1], scene.waterLevel + std::max(0.0, ground.height(shore[0], shore[1])) + eye };
  // A little below the horizon.
  const double far = 0.5 * extent;
  const double turn = heading + radians(Aside);
  camera.focus = { shore[0] - far * std::cos(turn), shore[1] - far * std::sin(turn), camera.eye[2] - Downwards * far };
  return camera;
}

}
