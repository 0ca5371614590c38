#include "GltfMotion.h"

#include <vtkBase64Utilities.h>

#include <algorithm>
#include <limits>

namespace swellray::scene
{

namespace
{

// Numbers of the glTF 2.0 specification.
constexpr int FloatComponents = 5126;

}

GltfMotion::GltfMotion(nlohmann::json& gltf)
  : Gltf(gltf)
{
}

std::size_t GltfMotion::addNumbers(const std::vector<float>& numbers, const char* type)
{
  const std::size_t components = std::string(type) == "VEC3" ? 3 : 1;
  std::vector<float> low(components, std::numeric_limits<float>::max());
  std::vector<float> high(components, std::numeric_limits<float>::lowest());
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    low[i % components] = std::min(low[i % components], numbers[i]);
    high[i % components] = std::max(high[i % components], numbers[i]);
  }
  const std::size_t length = numbers.size() * sizeof(float);
  auto& views = this->Gltf["bufferViews"];
  views.push_back(
    { { "buffer", this->Gltf.at("buffers").size() }, { "byteOffset", this->Bytes.size() }, { "byteLength", length } });
  this->Bytes.append(reinterpret_cast<const char*>(numbers.data()), length);
  auto& accessors = this->Gltf["accessors"];
  accessors.push_back({ { "bufferView", views.size() - 1 }, { "componentType", FloatComponents },
    { "count", numbers.size() / components }, { "type", type }, { "min", low }, { "max", high } });
  return accessors.size() - 1;
}

void GltfMotion::follow(
  std::size_t node, const char* path, std::size_t times, std::size_t values, const char* interpolation)
{
  this->Samplers.push_back({ { "input", times }, { "output", values }, { "interpolation", interpolation } });
  this->Channels.push_back(
    { { "sampler", this->Samplers.size() - 1 }, { "target", { { "node", node }, { "path", path } } } });
}

void GltfMotion::finish(const char* name)
{
  std::string text(4 * (this->Bytes.size() / 3 + 2), '\0');
  text.resize(vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(this->Bytes.data()), this->Bytes.size(),
    reinterpret_cast<unsigned char*>(text.data())));
  this->Gltf["buffers"].push_back(
    { { "byteLength", this->Bytes.size() }, { "uri", "data:application/octet-stream;base64," + text } });
  this->Gltf["animations"] =
    nlohmann::json::array({ { { "name", name }, { "samplers", this->Samplers }, { "channels", this->Channels } } });
}

}
