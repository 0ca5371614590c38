#pragma once

#include "ScenePicture.h"

#include <nlohmann/json_fwd.hpp>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace swellray::scene
{

/**
 * A scene as glTF 2.0, buffers within the file, metres, y up, x east, -z north: meshes `seafloor` and `sea` with normals and
 * a colour a point (SceneColors), `rays` as lines over the water, `spray` as points, and the camera of the content.
 *
 * With several times it has an animation `waves`: the places and normals of the sea are those of each time at that time and
 * go evenly in between (morph targets), its foam is that of the first; each time has points of spray of its own, which are
 * there until the next. Where the times are whole periods the waves go on from the last to the first.
 */
class GltfScene
{
public:
  /**
   * @param period of the waves, s
   * @param commandLine kept with the scene: asset.extras.CommandLine
   */
  GltfScene(const SceneContent& content, const std::string& title, double period, const std::string& commandLine = {});

  /** Show these rays (vtkSwellRayTracer), as rayLines() has them. */
  void setRays(vtkPolyData* rays);

  /**
   * Add the sea at a time, later than those before and as far from it as they are from each other.
   * @param surface of vtkSwellFoam: point arrays Normals and Foam, over the same sheet as those before
   * @param spray of vtkSwellSpray; null: none
   * @throws std::runtime_error where it is of another sheet
   */
  void add(vtkPolyData* surface, double time, vtkPolyData* spray = nullptr);

  /** @throws std::runtime_error where the file cannot be written */
  void write(const std::string& path) const;

private:
  struct Frame
  {
    double time = 0.0;
    std::vector<float> places; ///< in the axes of glTF
    std::vector<float> normals;
    vtkSmartPointer<vtkPolyData> spray;
  };

  void complete(const std::string& path, const std::vector<std::string>& names) const;
  void animate(nlohmann::json& gltf, const std::vector<std::size_t>& nodes) const;

  SceneContent Content;
  std::string Title;
  double Period;
  std::string CommandLine;
  vtkSmartPointer<vtkPolyData> Sea;
  vtkSmartPointer<vtkPolyData> Rays;
  std::vector<Frame> Frames;
};

}
