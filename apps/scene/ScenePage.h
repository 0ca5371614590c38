#pragma once

#include "ScenePicture.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace swellray::scene
{

/** What a page says of its scene, and how it is seen at first. */
struct PageDetails
{
  std::string title;
  double period = 10.0; ///< s
  CameraName camera = CameraName::Aerial;
  bool ownCamera = false; ///< that of the content, in place of the one by name
  std::string commandLine;
};

/**
 * A page of one file in which a browser shows the scene and plays its waves: the seafloor, the sea at each time, and the
 * library vtk.js that draws them, without anything to be fetched.
 *
 * Places of the sea and of spray are kept to 1/65535 of their range in each direction, normals to 1/127, foam to 1/255 and
 * velocities of spray to 1/127 of the largest.
 */
class ScenePage
{
public:
  ScenePage(const SceneContent& content, const PageDetails& details);

  /** Points of all frames together that a browser can still be given. */
  static constexpr std::size_t MostPoints = 4000000;

  /** Show these rays (vtkSwellRayTracer), as rayLines() has them. */
  void setRays(vtkPolyData* rays);

  /**
   * Add the sea at a time, later than those before and as far from it as they are from each other.
   * @param surface of vtkSwellFoam, over the same sheet as those before
   * @param spray of vtkSwellSpray: point array Velocity; null: none
   * @throws std::runtime_error where it is of another sheet
   */
  void add(vtkPolyData* surface, double time, vtkPolyData* spray = nullptr);

  /**
   * @param library text of vtk.js; a comment with which it begins is shown in the page
   * @throws std::runtime_error where the file cannot be written
   */
  void write(const std::string& path, const std::string& library) const;

private:
  struct Frame
  {
    double time = 0.0;
    std::vector<float> places;          ///< x, y, z of each point in turn
    std::vector<std::uint8_t> foam;     ///< 0 to 255
    std::vector<std::int8_t> direction; ///< normals, -127 to 127
    std::vector<float> spray;           ///< x, y, z of each particle in turn
    std::vector<float> velocity;        ///< of it, m/s
  };

  struct Range
  {
    std::array<double, 3> low{};
    std::array<double, 3> step{};
  };

  static Range rangeOf(const std::vector<Frame>& frames, std::vector<float> Frame::*which);
  static std::vector<std::uint8_t> planesOf(
    const std::vector<float>& places, const Range& range, std::vector<std::uint16_t>& before);
  std::string packed(std::string& header) const;

  SceneContent Content;
  PageDetails Details;
  std::vector<std::uint32_t> Triangles;
  std::vector<float> RayPlaces;          // x, y, z of each point in turn
  std::vector<std::uint32_t> RayLengths; // points of each line
  std::vector<Frame> Frames;
};

}
