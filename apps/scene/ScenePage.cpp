#include "ScenePage.h"

#include "RayLines.h"
#include "SceneColors.h"

#include "apps/drawing/Relief.h"

#include <nlohmann/json.hpp>

#include <vtkBase64Utilities.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace swellray::scene
{

// The page with places for its parts: web/scene.html, made part of the program by the build.
extern const char* const PageText;

namespace
{

// Of the seafloor: finer than a screen shows of the whole.
constexpr vtkIdType MostBedNodes = 100000;

constexpr int BedShades = 64; // of water, and as many of land
constexpr int FoamShades = 16;

std::string compressed(const std::string& bytes)
{
  vtkNew<vtkZLibDataCompressor> compressor;
  compressor->SetCompressionLevel(9);
  const auto* from = reinterpret_cast<const unsigned char*>(bytes.data());
  std::string squeezed(compressor->GetMaximumCompressionSpace(bytes.size()), '\0');
  const std::size_t length =
    compressor->Compress(from, bytes.size(), reinterpret_cast<unsigned char*>(squeezed.data()), squeezed.size());
  std::string text(4 * (length / 3 + 2), '\0');
  text.resize(vtkBase64Utilities::Encode(
    reinterpret_cast<const unsigned char*>(squeezed.data()), length, reinterpret_cast<unsigned char*>(text.data())));
  return text;
}

template <typename Value>
void append(std::string& bytes, const std::vector<Value>& values)
{
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
}

nlohmann::json jsonOf(const SceneCamera& camera)
{
  return { { "eye", camera.eye }, { "focus", camera.focus }, { "up", camera.up }, { "angle", camera.angle } };
}

// HTML shows these characters as markup.
std::string asText(const std::string& words)
{
  std::string safe;
  for (const char c : words)
  {
    switch (c)
    {
    case '&':
      safe += "&amp;";
      break;
    case '<':
      safe += "&lt;";
      break;
    case '>':
      safe += "&gt;";
      break;
    default:
      safe += c;
    }
  }
  return safe;
}

// The comment with which a script begins.
std::string noticeOf(const std::string& library)
{
  const auto end = library.find("*/");
  return library.rfind("/*", 0) == 0 && end != std::string::npos ? asText(library.substr(3, end - 3)) : std::string();
}

void fill(std::string& page, const std::string& place, const std::string& words)
{
  const auto at = page.find(place);
  page.replace(at, place.size(), words);
}

}

ScenePage::ScenePage(const SceneContent& content, const PageDetails& details)
  : Content(content)
  , Details(details)
{
}

void ScenePage::setRays(vtkPolyData* rays)
{
  const vtkSmartPointer<vtkPolyData> lines = rayLines(rays, this->Content.waterLevel + this->Content.waveHeight);
  vtkCellArray* cells = lines->GetLines();
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    this->RayLengths.push_back(static_cast<std::uint32_t>(cells->GetCellSize(i)));
  }
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    double p[3];
    lines->GetPoint(i, p);
    this->RayPlaces.insert(
      this->RayPlaces.end(), { static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]) });
  }
}

void ScenePage::add(vtkPolyData* surface, double time, vtkPolyData* spray)
{
  const auto count = static_cast<std::size_t>(surface->GetNumberOfPoints());
  if (this->Frames.empty())
  {
    vtkCellArray* cells = surface->GetPolys();
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
    {
      vtkIdType corners = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCellAtId(i, corners, ids);
      for (vtkIdType j = 0; j < 3; ++j)
      {
        this->Triangles.push_back(static_cast<std::uint32_t>(ids[j]));
      }
    }
  }
  else if (count != this->Frames.front().foam.size())
  {
    throw std::runtime_error("the frames of a page are to be of one sheet of points");
  }
  Frame frame;
  frame.time = time;
  frame.places.resize(3 * count);
  frame.direction.resize(3 * count);
  frame.foam.resize(count);
  vtkDataArray* normals = surface->GetPointData()->GetArray("Normals");
  vtkDataArray* foam = surface->GetPointData()->GetArray("Foam");
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    double p[3];
    surface->GetPoint(id, p);
    for (std::size_t j = 0; j < 3; ++j)
    {
      frame.places[3 * i + j] = static_cast<float>(p[j]);
      const double n = normals->GetComponent(id, static_cast<int>(j));
      frame.direction[3 * i + j] = static_cast<std::int8_t>(std::lround(127.0 * std::clamp(n, -1.0, 1.0)));
    }
    frame.foam[i] = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(foam->GetComponent(id, 0), 0.0, 1.0)));
  }
  const vtkIdType particles = spray ? spray->GetNumberOfPoints() : 0;
  vtkDataArray* velocity = spray ? spray->GetPointData()->GetArray("Velocity") : nullptr;
  for (vtkIdType i = 0; i < particles; ++i)
  {
    double p[3];
    spray->GetPoint(i, p);
    for (int j = 0; j < 3; ++j)
    {
      frame.spray.push_back(static_cast<float>(p[j]));
      frame.velocity.push_back(static_cast<float>(velocity->GetComponent(i, j)));
    }
  }
  this->Frames.push_back(std::move(frame));
}

ScenePage::Range ScenePage::rangeOf(const std::vector<Frame>& frames, std::vector<float> Frame::*which)
{
  Range range;
  for (std::size_t j = 0; j < 3; ++j)
  {
    double least = std::numeric_limits<double>::max();
    double most = std::numeric_limits<double>::lowest();
    for (const Frame& frame : frames)
    {
      const std::vector<float>& places = frame.*which;
      for (std::size_t i = j; i < places.size(); i += 3)
      {
        least = std::min<double>(least, places[i]);
        most = std::max<double>(most, places[i]);
      }
    }
    range.low[j] = least <= most ? least : 0.0; // of none, too
    range.step[j] = most > least ? (most - least) / 65535.0 : 1.0;
  }
  return range;
}

// Places as steps of their range less those before, in low and high bytes; `before` becomes them.
std::vector<std::uint8_t> ScenePage::planesOf(
  const std::vector<float>& places, const Range& range, std::vector<std::uint16_t>& before)
{
  const std::size_t count = places.size() / 3;
  std::vector<std::uint8_t> planes(6 * count);
  for (std::size_t i = 0; i < 3 * count; ++i)
  {
    const std::size_t j = i % 3;
    const auto place = static_cast<std::uint16_t>(std::lround((places[i] - range.low[j]) / range.step[j]));
    const auto change = static_cast<std::uint16_t>(place - before[i]);
    const std::size_t at = 2 * j * count + i / 3;
    planes[at] = static_cast<std::uint8_t>(change & 0xff);
    planes[at + count] = static_cast<std::uint8_t>(change >> 8);
    before[i] = place;
  }
  return planes;
}

std::string ScenePage::packed(std::string& header) const
{
  using nlohmann::json;
  const SceneContent& content = this->Content;
  const std::size_t count = this->Frames.front().foam.size();

  // Seafloor: elevations of nodes; triangles around holes are left out by the page.
  int size[3];
  content.seafloor->GetDimensions(size);
  const double nodes = static_cast<double>(size[0]) * size[1];
  const int stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(nodes / static_cast<double>(MostBedNodes)))));
  const int columns = (size[0] - 1) / stride + 1;
  const int rows = (size[1] - 1) / stride + 1;
  vtkDataArray* elevations = content.seafloor->GetPointData()->GetArray("Elevation");
  std::vector<float> elevation;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      elevation.push_back(static_cast<float>(elevations->GetComponent(
        static_cast<vtkIdType>(j) * stride * size[0] + static_cast<vtkIdType>(i) * stride, 0)));
    }
  }

  const Range places = rangeOf(this->Frames, &Frame::places);
  const Range drops = rangeOf(this->Frames, &Frame::spray);
  float fastest = 0.0f;
  for (const Frame& frame : this->Frames)
  {
    for (const float v : frame.velocity)
    {
      fastest = std::max(fastest, std::abs(v));
    }
  }
  std::string bytes;
  append(bytes, elevation);
  append(bytes, this->Triangles);
  append(bytes, this->RayLengths);
  append(bytes, this->RayPlaces);
  // What changes from frame to frame is little: it packs better than the places do.
  std::vector<std::uint16_t> before(3 * count, 0);
  json particles = json::array();
  for (const Frame& frame : this->Frames)
  {
    append(bytes, planesOf(frame.places, places, before));
    append(bytes, frame.direction);
    append(bytes, frame.foam);
    std::vector<std::uint16_t> none(frame.spray.size(), 0);
    append(bytes, planesOf(frame.spray, drops, none));
    std::vector<std::int8_t> velocity;
    for (const float v : frame.velocity)
    {
      velocity.push_back(static_cast<std::int8_t>(std::lround(127.0f * v / fastest)));
    }
    append(bytes, velocity);
    particles.push_back(frame.spray.size() / 3);
  }

  const double* origin = content.seafloor->GetOrigin();
  const double* spacing = content.seafloor->GetSpacing();
  const SceneColors colors(content.seafloor, content.waterLevel);
  json bedColors = json::array();
  for (int i = 0; i < 2 * BedShades; ++i)
  {
    const bool wet = i < BedShades;
    const double t = static_cast<double>(wet ? i : i - BedShades) / (BedShades - 1);
    const double from = wet ? colors.lowest() : content.waterLevel;
    const double to = wet ? content.waterLevel : colors.highest();
    if (!(to > from))
    {
      continue;
    }
    // The shore is dry on its side of the water level.
    const double at = wet && i == BedShades - 1 ? std::nextafter(to, from) : from + t * (to - from);
    bedColors.push_back({ at, colors.bed(at) });
  }
  json foamColors = json::array();
  for (int i = 0; i < FoamShades; ++i)
  {
    foamColors.push_back(SceneColors::water(i / (FoamShades - 1.0)));
  }
  double duration = this->Details.period;
  bool loops = false;
  if (this->Frames.size() > 1)
  {
    const double between = this->Frames[1].time - this->Frames[0].time;
    duration = between * static_cast<double>(this->Frames.size());
    const double waves = duration / this->Details.period;
    constexpr double Whole = 1e-6;
    loops = std::abs(waves - std::round(waves)) < Whole;
  }
  std::vector<double> times;
  for (const Frame& frame : this->Frames)
  {
    times.push_back(frame.time);
  }
  const CameraScene scene{ content.seafloor, content.waterLevel, content.directionFrom, content.waveHeight };
  json cameras{ { "shore", jsonOf(cameraByName(CameraName::Shore, scene)) },
    { "aerial", jsonOf(cameraByName(CameraName::Aerial, scene)) },
    { "chart", jsonOf(cameraByName(CameraName::Chart, scene)) } };
  const char* const names[] = { "shore", "aerial", "chart" };
  std::string first = names[static_cast<std::size_t>(this->Details.camera)];
  if (this->Details.ownCamera)
  {
    first = "own";
    cameras["own"] = jsonOf(content.camera);
  }
  double bounds[6];
  content.seafloor->GetBounds(bounds);
  const json data{ { "title", this->Details.title }, { "commandLine", this->Details.commandLine },
    { "period", this->Details.period }, { "directionFrom", content.directionFrom }, { "height", content.waveHeight },
    { "waterLevel", content.waterLevel }, { "times", times }, { "duration", duration }, { "loops", loops },
    { "extent", std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]) }, { "sun", content.sky.sun() },
    { "cameras", cameras }, { "camera", first },
    { "bed",
      { { "columns", columns }, { "rows", rows }, { "origin", { origin[0], origin[1] } },
        { "spacing", { spacing[0] * stride, spacing[1] * stride } }, { "colors", bedColors } } },
    { "water",
      { { "points", count }, { "triangles", this->Triangles.size() / 3 }, { "low", places.low },
        { "step", places.step }, { "colors", foamColors }, { "opacity", SceneColors::WaterOpacity } } },
    { "rays", { { "lines", this->RayLengths.size() }, { "points", this->RayPlaces.size() / 3 } } },
    { "spray", { { "particles", particles }, { "low", drops.low }, { "step", drops.step }, { "fastest", fastest } } } };
  header = data.dump();
  return compressed(bytes);
}

void ScenePage::write(const std::string& path, const std::string& library) const
{
  std::string header;
  const std::string bytes = this->packed(header);
  // Ends of elements within the data are no ends of the element that holds it.
  for (std::size_t at = 0; (at = header.find('<', at)) != std::string::npos;)
  {
    header.replace(at, 1, "\\u003c");
  }
  std::string page = PageText;
  // Later parts come first, so that nothing within a part is taken for a place.
  fill(page, "@LIBRARY@", compressed(library));
  fill(page, "@BYTES@", bytes);
  fill(page, "@HEADER@", header);
  fill(page, "@NOTICE@", noticeOf(library));
  fill(page, "@TITLE@", asText(this->Details.title));
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out << page;
  out.close();
  if (!out)
  {
    throw std::runtime_error("it could not be written whole");
  }
}

}
