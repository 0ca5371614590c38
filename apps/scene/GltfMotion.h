#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace swellray::scene
{

/**
 * What a glTF file needs for a mesh that changes in time: numbers are gathered in one buffer, which is put in at the end.
 */
class GltfMotion
{
public:
  explicit GltfMotion(nlohmann::json& gltf);

  /**
   * Numbers as an accessor with their bounds.
   * @param type SCALAR or VEC3
   * @return its index
   */
  std::size_t addNumbers(const std::vector<float>& numbers, const char* type);

  /**
   * Let a node follow values in time.
   * @param path of the node: weights, scale
   * @param times accessor, s
   * @param values accessor
   * @param interpolation LINEAR or STEP
   */
  void follow(std::size_t node, const char* path, std::size_t times, std::size_t values, const char* interpolation);

  /** Put the buffer and the animation into the file. */
  void finish(const char* name);

private:
  nlohmann::json& Gltf;
  nlohmann::json Samplers = nlohmann::json::array();
  nlohmann::json Channels = nlohmann::json::array();
  std::string Bytes;
};

}
