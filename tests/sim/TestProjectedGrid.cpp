#include "sim/ProjectedGrid.h"

#include "RayBundle.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

using namespace swellray;
using namespace swellray::bundles;

namespace
{

// What is straight and of one depth is interpolated exactly.
constexpr double Rounding = 1e-8;

constexpr double Omega = 2.0 * Pi / Period;

// From x = 20 m forward over the 20 m wide strip of waves.
GridCamera camera()
{
  GridCamera camera;
  camera.position = { 20.0, 10.0, 12.0 };
  camera.focalPoint = { 60.0, 10.0, 0.0 };
  camera.viewAngle = 40.0;
  camera.width = 320;
  camera.height = 240;
  return camera;
}

/** The same with samples so close that they resolve the waves. */
GridCamera fine()
{
  GridCamera camera = ::camera();
  camera.step = 2;
  return camera;
}

struct Sea
{
  explicit Sea(const char* name = "airy")
    : Bed(20.0, 0.0)
    , Waves(straight(7.0), Bed)
    , Function(*Waves.Moved)
    , Section(makeWaveSection(name))
  {
    this->Motion.section = this->Section.get();
  }

  Slope Bed;
  Surface Waves;
  SurfaceFunction Function;
  std::unique_ptr<WaveSection> Section;
  SurfaceMotion Motion;
};

/** Pixel at which a point is seen, from the middle of the picture. */
glm::dvec2 pixelOf(const glm::dvec3& point, const GridCamera& camera)
{
  const glm::dvec3 ahead = glm::normalize(camera.focalPoint - camera.position);
  const glm::dvec3 right = glm::normalize(glm::cross(ahead, camera.viewUp));
  const glm::dvec3 up = glm::cross(right, ahead);
  const glm::dvec3 sight = point - camera.position;
  const double scale = 0.5 * camera.height / std::tan(0.5 * camera.viewAngle * Pi / 180.0) / glm::dot(sight, ahead);
  return scale * glm::dvec2(glm::dot(sight, right), glm::dot(sight, up));
}

}

TEST(ProjectedGrid, hasASampleAtEveryNthPixel)
{
  const GridCamera at = camera();
  Bundle calm = straight(7.0);
  std::fill(calm.Height.begin(), calm.Height.end(), 0.0);
  const Sea sea;
  const Surface still(calm, sea.Bed);
  const SurfaceFunction function(*still.Moved);
  const ProjectedSurface surface = ProjectedGrid(at, 0.0).sample({ &function }, 0.0, sea.Motion);
  ASSERT_GT(surface.position.size(), 300u);
  for (const glm::dvec3& point : surface.position)
  {
    EXPECT_NEAR(point.z, 0.0, Rounding);
    EXPECT_GE(point.y, -Rounding);
    EXPECT_LE(point.y, 20.0 + Rounding);
    const glm::dvec2 pixel = (pixelOf(point, at) + glm::dvec2(160.0, 120.0)) / 8.0;
    EXPECT_NEAR(pixel.x, std::round(pixel.x), 1e-7);
    EXPECT_NEAR(pixel.y, std::round(pixel.y), 1e-7);
  }
}

TEST(ProjectedGrid, showsTheSurfaceOfTheFunction)
{
  const Sea sea;
  for (const double time : { 0.0, 1.9 })
  {
    const ProjectedSurface surface = ProjectedGrid(fine(), 0.0).sample({ &sea.Function }, time, sea.Motion);
    for (std::size_t i = 0; i < surface.position.size(); ++i)
    {
      const glm::dvec3& point = surface.position[i];
      const double phase = K * point.x - Omega * time;
      EXPECT_NEAR(point.z, 0.5 * std::cos(phase), Rounding);
      const glm::dvec3 normal = glm::normalize(glm::dvec3(0.5 * K * std::sin(phase), 0.0, 1.0));
      EXPECT_NEAR(glm::distance(surface.normal[i], normal), 0.0, Rounding);
      EXPECT_NEAR(surface.velocity[i].z, 0.5 * Omega * std::sin(phase), Rounding);
      EXPECT_NEAR(surface.depth[i], 20.0, Rounding);
    }
  }
}

TEST(ProjectedGrid, movesAlongTheWaveAsTheMeshDoes)
{
  Sea sea("gerstner");
  const double time = 2.2;
  const ProjectedSurface surface = ProjectedGrid(fine(), 0.0).sample({ &sea.Function }, time, sea.Motion);
  double along = 0.0;
  for (std::size_t i = 0; i < surface.position.size(); ++i)
  {
    const glm::dvec3& point = surface.position[i];
    const SurfaceValue value = sea.Function.at({ point.x, point.y }, time, sea.Motion);
    if (value.covered && point.y > 0.1 && point.y < 19.9)
    {
      EXPECT_NEAR(point.z, value.elevation, 1e-6);
      EXPECT_NEAR(glm::distance(surface.normal[i], value.normal), 0.0, 1e-5);
      along = std::max(along, std::abs(value.velocity.x));
    }
  }
  EXPECT_GT(along, 0.1);
}

TEST(ProjectedGrid, addsWavesAndLooksUp)
{
  const Sea sea;
  Bundle across;
  for (int i = 0; i < 30; ++i)
  {
    across.begin(5.0 * i);
    for (double y = -30.0; y < 60.5; y += 2.0)
    {
      across.add({ 130.0 - 5.0 * i, y }, 0.4 * y, { 0.0, 1.0 }, 0.3, 0.0, RayState::Alive, 0.4);
    }
  }
  const Surface second(across, sea.Bed);
  const SurfaceFunction other(*second.Moved);
  GridCamera near = camera();
  near.step = 2; // which resolves both
  near.focalPoint = { 35.0, 10.0, 0.0 };
  near.viewAngle = 25.0;
  near.margin = 0;
  const ProjectedSurface surface = ProjectedGrid(near, 0.0).sample({ &sea.Function, &other }, 0.0, sea.Motion);
  for (std::size_t i = 0; i < surface.position.size(); ++i)
  {
    const glm::dvec3& point = surface.position[i];
    const bool first = point.y >= 0.0 && point.y <= 20.0;
    EXPECT_NEAR(point.z, (first ? 0.5 * std::cos(K * point.x) : 0.0) + 0.15 * std::cos(0.4 * point.y), 1e-6);
  }
  ASSERT_GT(surface.triangles.size(), 1000u);
  for (const auto& triangle : surface.triangles)
  {
    const auto corner = [&](int c) { return surface.position[static_cast<std::size_t>(triangle[c])]; };
    EXPECT_GT(glm::cross(corner(1) - corner(0), corner(2) - corner(0)).z, 0.0);
  }
}

TEST(ProjectedGrid, leavesOutWhatItsSamplesDoNotResolve)
{
  const Sea sea;
  GridCamera high = camera();
  high.position.z = 4000.0;
  high.focalPoint = { 60.0, 10.0, 0.0 };
  high.viewUp = { 1.0, 0.0, 0.0 };
  high.viewAngle = 2.0;
  // Straight from above, with 120 m in 240 pixels: 21 m between samples of 40 m long waves, or 10 m.
  high.step = 42;
  high.viewAngle = 2.0 * std::atan(60.0 / 4000.0) * 180.0 / Pi;
  for (const glm::dvec3& point : ProjectedGrid(high, 0.0).sample({ &sea.Function }, 0.0, sea.Motion).position)
  {
    EXPECT_NEAR(point.z, 0.0, Rounding);
  }
  high.step = 20;
  const auto close = ProjectedGrid(high, 0.0).sample({ &sea.Function }, 0.0, sea.Motion).position;
  EXPECT_GT(
    std::max_element(close.begin(), close.end(), [](const auto& a, const auto& b) { return a.z < b.z; })->z, 0.3);
}

TEST(ProjectedGrid, costsWhatItsPictureHasPixels)
{
  GridCamera wide = camera();
  wide.position.z = 500.0;
  wide.focalPoint = { 2000.0, 10.0, 0.0 };
  const std::size_t near = ProjectedGrid(camera(), 0.0).sampleCount();
  const std::size_t far = ProjectedGrid(wide, 0.0).sampleCount();
  // (320 + 2 64)/8 + 1 by (240 + 2 64)/8 + 1, less the sky.
  EXPECT_LE(near, 57u * 47u);
  EXPECT_LE(far, 57u * 47u);
  EXPECT_GT(far, 25u * 47u);
  wide.step = 4;
  EXPECT_NEAR(static_cast<double>(ProjectedGrid(wide, 0.0).sampleCount()), 4.0 * static_cast<double>(far),
    0.15 * static_cast<double>(4 * far));
}

TEST(ProjectedGrid, isTheSameForAnyLoop)
{
  const Sea sea("gonzato-lesaec");
  const ProjectedGrid grid(camera(), 0.0);
  Execution backwards;
  backwards.loop = [](std::size_t n, const auto& body)
  {
    for (std::size_t i = n; i > 0; --i)
    {
      body(i - 1, i);
    }
  };
  const auto whole = grid.sample({ &sea.Function }, 1.0, sea.Motion);
  const auto parts = grid.sample({ &sea.Function }, 1.0, sea.Motion, backwards);
  EXPECT_EQ(whole.position, parts.position);
  EXPECT_EQ(whole.foam, parts.foam);
  EXPECT_EQ(whole.triangles, parts.triangles);
}

TEST(ProjectedGrid, refusesWhatMakesNoSense)
{
  const auto refused = [](const auto& change)
  {
    GridCamera bad = camera();
    change(bad);
    EXPECT_THROW(ProjectedGrid(bad, 0.0), std::invalid_argument);
  };
  refused([](GridCamera& bad) { bad.position.z = -1.0; });
  refused([](GridCamera& bad) { bad.position.x = std::numeric_limits<double>::quiet_NaN(); });
  refused([](GridCamera& bad) { bad.focalPoint = bad.position; });
  refused([](GridCamera& bad) { bad.viewUp = bad.focalPoint - bad.position; });
  refused([](GridCamera& bad) { bad.viewAngle = 180.0; });
  refused([](GridCamera& bad) { bad.step = 0; });
  refused([](GridCamera& bad) { bad.width = 100000; });
  refused([](GridCamera& bad) { bad.margin = -1; });
  const Sea sea;
  EXPECT_THROW(ProjectedGrid(camera(), 0.0).sample({}, 0.0, sea.Motion), std::invalid_argument);
  EXPECT_THROW(ProjectedGrid(camera(), 1.0).sample({ &sea.Function }, 0.0, sea.Motion), std::invalid_argument);
}
