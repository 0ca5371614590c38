#include "ChartLines.h"

#include "ContourLabels.h"
#include "Failure.h"

#include "sim/RayField.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace swellray::cli
{

using namespace drawing;

namespace
{

// Lines closer together than these many type sizes are thinned out.
constexpr double RayGap = 0.45;
constexpr double CrestGap = 0.9;

// A picture shows at least about this many of the launched rays.
constexpr int LeastRays = 80;

// Contour lines shorter than these many type sizes are specks: noise where the bed is flat.
constexpr double LeastContour = 1.0;

// Points nearer than this (pixels) to the one before are not drawn.
constexpr double PointGap = 0.7;

const Rgb ContourColor{ 0.16, 0.27, 0.38 };
const Rgb RayOverMapColor{ 0.10, 0.12, 0.20 };
const Rgb AgroundColor{ 0.36, 0.27, 0.20 };
const Rgb CrestColor{ 1.0, 1.0, 1.0 };
const Rgb ObstacleColor{ 0.45, 0.05, 0.12 };

const std::map<std::string, std::pair<std::string, std::string>> Names{
  { "WaveHeight", { "Wave height", "m" } },
  { "Depth", { "Depth", "m" } },
  { "Phase", { "Phase", "rad" } },
  { "TravelTime", { "Travel time", "s" } },
  { "Wavenumber", { "Wavenumber", "rad/m" } },
  { "Wavelength", { "Wavelength", "m" } },
  { "PhaseSpeed", { "Phase speed", "m/s" } },
  { "GroupSpeed", { "Group speed", "m/s" } },
  { "DirectionFrom", { "Direction from", "deg" } },
  { "RefractionCoefficient", { "Refraction Kr", "" } },
  { "KrSpacing", { "Kr by spacing", "" } },
  { "KrTube", { "Kr by tube", "" } },
  { "TubeWidth", { "Tube width", "" } },
  { "ShoalingCoefficient", { "Shoaling Ks", "" } },
  { "EnergyFlux", { "Energy flux", "W/m" } },
  { "OrbitalVelocity", { "Velocity at bed", "m/s" } },
  { "Caustics", { "Caustics passed", "" } },
  { "Breaking", { "Breaking", "" } },
  { "Elevation", { "Elevation", "m" } },
  { "SignificantWaveHeight", { "Significant height", "m" } },
  { "PeakPeriod", { "Peak period", "s" } },
  { "MeanPeriod", { "Mean period", "s" } },
  { "MeanDirectionFrom", { "Mean direction from", "deg" } },
  { "DirectionalSpread", { "Spread", "deg" } },
};

// Metres to pixels.
struct Projection
{
  double originX, originY, scale, left, bottom;

  Projection(const ChartContent& content, const ChartLayout& layout)
  {
    double bounds[6];
    content.seafloor->GetBounds(bounds);
    this->originX = bounds[0];
    this->originY = bounds[2];
    this->scale = layout.map.width / (bounds[1] - bounds[0]);
    this->left = layout.map.x;
    this->bottom = layout.map.y;
  }
  std::array<double, 2> operator()(const double* point) const
  {
    return { this->left + (point[0] - this->originX) * this->scale,
      this->bottom + (point[1] - this->originY) * this->scale };
  }
};

void append(PixelLine& line, const std::array<double, 2>& at, const Rgb& color, double opacity)
{
  line.points.push_back(static_cast<float>(at[0]));
  line.points.push_back(static_cast<float>(at[1]));
  for (const double channel : color)
  {
    line.colors.push_back(static_cast<unsigned char>(std::lround(255.0 * channel)));
  }
  line.colors.push_back(static_cast<unsigned char>(std::lround(255.0 * opacity)));
}

bool isFar(const PixelLine& line, const std::array<double, 2>& at)
{
  const std::size_t n = line.points.size();
  return n < 2 || std::hypot(at[0] - line.points[n - 2], at[1] - line.points[n - 1]) >= PointGap;
}

double lengthOf(const PixelLine& line)
{
  double length = 0.0;
  for (std::size_t i = 2; i + 1 < line.points.size(); i += 2)
  {
    length += std::hypot(line.points[i] - line.points[i - 2], line.points[i + 1] - line.points[i - 1]);
  }
  return length;
}

void keep(ChartLines& lines, PixelLine& line)
{
  if (line.points.size() >= 4)
  {
    ++lines.counts[line.kind];
    lines.lines.push_back(std::move(line));
  }
  line = PixelLine{};
}

// @param words written along the line where there is a place for them
void addPlainLine(ChartLines& lines, vtkPolyData* data, vtkIdType cell, const ChartLayout& layout,
  const Projection& project, LineKind kind, const Rgb& color, double opacity, double leastLength = 0.0,
  const std::string& words = "")
{
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  data->GetCellPoints(cell, count, ids);
  PixelLine line;
  line.kind = kind;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto at = project(data->GetPoint(ids[i]));
    if (isFar(line, at) || i + 1 == count)
    {
      append(line, at, color, opacity);
    }
  }
  if (lengthOf(line) < leastLength)
  {
    return;
  }
  PixelLine rest;
  if (!words.empty() && labelContour(line, words, layout, lines.labels, rest))
  {
    keep(lines, rest);
    --lines.counts[kind]; // one line in two parts
  }
  keep(lines, line);
}

void addContours(ChartLines& lines, const ChartContent& content, const ChartLayout& layout, const Projection& project)
{
  vtkDataArray* depths = content.contours->GetCellData()->GetArray("Depth");
  std::set<double> levels;
  for (vtkIdType cell = 0; cell < content.contours->GetNumberOfCells(); ++cell)
  {
    const double depth = depths ? depths->GetComponent(cell, 0) : 1.0;
    const bool shore = std::abs(depth) < 1e-9;
    if (shore)
    {
      continue; // the picture of the seafloor has it
    }
    if (depth > 0.0)
    {
      levels.insert(depth);
    }
    addPlainLine(lines, content.contours, cell, layout, project, LineKind::Contour, ContourColor, 0.55,
      LeastContour * layout.unit, shortNumber(depth));
  }
  const std::vector<double> sorted(levels.begin(), levels.end());
  if (sorted.size() >= 3)
  {
    const double step = sorted[1] - sorted[0];
    bool equal = true;
    for (std::size_t i = 2; i < sorted.size(); ++i)
    {
      equal = equal && std::abs(sorted[i] - sorted[i - 1] - step) < 1e-6 * step;
    }
    lines.contourInterval = equal ? step : 0.0;
  }
}

void addCrests(ChartLines& lines, const ChartContent& content, const ChartLayout& layout, const Projection& project)
{
  vtkDataArray* numbers = content.crests->GetCellData()->GetArray("CrestNumber");
  if (numbers && numbers->GetNumberOfTuples() > 0)
  {
    double range[2];
    numbers->GetRange(range, 0);
    // The file may hold every crest, or every so many.
    long long held = 0;
    for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
    {
      held = std::gcd(held, static_cast<long long>(numbers->GetComponent(i, 0)));
    }
    const int base = static_cast<int>(std::max(1LL, held));
    const double across = std::hypot(layout.map.width, layout.map.height);
    const double gap = across / std::max(1.0, range[1] - range[0]);
    const double wanted = CrestGap * layout.unit / gap;
    lines.crestStride = base;
    for (const int stride : { 2, 5, 10, 20, 50, 100, 200, 500, 1000 })
    {
      lines.crestStride = lines.crestStride < wanted ? stride * base : lines.crestStride;
    }
  }
  for (vtkIdType cell = 0; cell < content.crests->GetNumberOfCells(); ++cell)
  {
    const auto number = numbers ? static_cast<long long>(numbers->GetComponent(cell, 0)) : 0;
    if (number % lines.crestStride == 0)
    {
      addPlainLine(lines, content.crests, cell, layout, project, LineKind::Crest, CrestColor, 0.7);
    }
  }
}

void addObstacles(ChartLines& lines, const ChartContent& content, const Projection& project)
{
  for (const Obstacle& obstacle : content.obstacles)
  {
    PixelLine line;
    line.kind = LineKind::Obstacle;
    const std::size_t count = obstacle.points.size();
    for (std::size_t i = 0; i < (obstacle.closed ? count + 1 : count); ++i)
    {
      const glm::dvec2& corner = obstacle.points[i % count];
      const auto at = project(&corner.x);
      if (isFar(line, at) || i + 1 >= count)
      {
        append(line, at, ObstacleColor, 1.0);
      }
    }
    keep(lines, line);
  }
}

// Every how many rays one is drawn, so that they stay apart on the picture.
int rayStride(vtkPolyData* rays, const ChartLayout& layout, const Projection& project)
{
  vtkDataArray* spacing = rays->GetFieldData()->GetArray("LaunchSpacing");
  if (!spacing || spacing->GetNumberOfTuples() == 0)
  {
    return 1;
  }
  const double pixels = spacing->GetComponent(0, 0) * project.scale;
  const double wanted = pixels > 0.0 ? RayGap * layout.unit / pixels : 1.0;
  const double most = static_cast<double>(rays->GetNumberOfCells()) / LeastRays;
  return std::max(1, static_cast<int>(std::ceil(std::min(wanted, most))));
}

// Of the launched, the inserted and the lee rays, each in the order of the launch parameter, every stride-th; of lee
// rays, which crowd where they start, as many as of the launched ones.
std::vector<vtkIdType> raysToDraw(vtkPolyData* rays, int stride)
{
  std::vector<vtkIdType> order(static_cast<std::size_t>(rays->GetNumberOfCells()));
  std::iota(order.begin(), order.end(), vtkIdType(0));
  vtkDataArray* lambda = rays->GetCellData()->GetArray("LaunchParameter");
  vtkDataArray* parent = rays->GetCellData()->GetArray("ParentRay");
  vtkDataArray* lee = rays->GetCellData()->GetArray("LeeRay");
  if (lambda)
  {
    std::stable_sort(order.begin(), order.end(),
      [&](vtkIdType a, vtkIdType b) { return lambda->GetComponent(a, 0) < lambda->GetComponent(b, 0); });
  }
  const auto kindOf = [&](vtkIdType ray)
  {
    const bool isLee = lee && lee->GetComponent(ray, 0) != 0.0;
    const bool inserted = parent && parent->GetComponent(ray, 0) >= 0.0;
    return static_cast<std::size_t>(isLee ? 2 : inserted ? 1 : 0);
  };
  std::array<int, 3> counts{};
  for (const vtkIdType ray : order)
  {
    ++counts[kindOf(ray)];
  }
  const int leeStride = std::max(stride, counts[0] > 0 ? stride * counts[2] / counts[0] : 1);
  const std::array<int, 3> strides{ stride, stride, leeStride };
  // The launched ones last, on top of the others.
  std::array<std::vector<vtkIdType>, 3> chosen;
  std::array<int, 3> seen{};
  for (const vtkIdType ray : order)
  {
    const std::size_t kind = kindOf(ray);
    if (seen[kind]++ % strides[kind] == 0)
    {
      chosen[2 - kind].push_back(ray);
    }
  }
  std::vector<vtkIdType> all;
  for (const std::vector<vtkIdType>& kind : chosen)
  {
    all.insert(all.end(), kind.begin(), kind.end());
  }
  return all;
}

class RayLinesMaker
{
public:
  RayLinesMaker(ChartLines& lines, const ChartContent& content, const RayColors& colors, const Projection& project)
    : Lines(lines)
    , Rays(content.rays)
    , Colors(colors)
    , Map(*content.colors)
    , Project(project)
    , Value(content.rays->GetPointData()->GetArray(content.colorBy.c_str()))
    , State(content.rays->GetPointData()->GetArray("RayState"))
    , Breaking(content.rays->GetPointData()->GetArray("Breaking"))
    , Lee(content.rays->GetCellData()->GetArray("LeeRay"))
  {
  }

  void add(vtkIdType ray)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    this->Rays->GetCellPoints(ray, count, ids);
    const bool lee = this->Lee && this->Lee->GetComponent(ray, 0) != 0.0;
    PixelLine line;
    bool broken = false;
    for (vtkIdType i = 0; i < count; ++i)
    {
      const auto at = this->Project(this->Rays->GetPoint(ids[i]));
      const int state = this->stateOf(ids[i]);
      this->Lines.states[static_cast<std::size_t>(state)] = true;
      const bool aground = state == static_cast<int>(RayState::Aground);
      const LineKind kind = aground ? LineKind::AgroundRay : lee ? LineKind::LeeRay : LineKind::Ray;
      const Rgb color = this->colorOf(ids[i], state, aground);
      if (!line.points.empty() && kind != line.kind)
      {
        append(line, at, color, 1.0);
        keep(this->Lines, line);
      }
      line.kind = kind;
      if (isFar(line, at) || i + 1 == count)
      {
        append(line, at, color, 1.0);
      }
      const bool breaks = this->Breaking && !aground && this->Breaking->GetComponent(ids[i], 0) != 0.0;
      if (breaks && !broken)
      {
        this->Lines.breakers.push_back(static_cast<float>(at[0]));
        this->Lines.breakers.push_back(static_cast<float>(at[1]));
      }
      broken = broken || breaks;
    }
    keep(this->Lines, line);
  }

private:
  int stateOf(vtkIdType point) const
  {
    const int state = this->State ? static_cast<int>(this->State->GetComponent(point, 0)) : 1;
    return std::clamp(state, 0, 3);
  }

  Rgb colorOf(vtkIdType point, int state, bool aground) const
  {
    switch (this->Colors.kind)
    {
    case RayColors::Kind::States:
      return stateColor(state);
    case RayColors::Kind::Scale:
    {
      const double value = this->Value->GetComponent(point, 0);
      if (aground || std::isnan(value))
      {
        return AgroundColor;
      }
      return this->Map.rgb(this->Colors.range.share(value));
    }
    default:
      return aground ? AgroundColor : this->Colors.plain;
    }
  }

  ChartLines& Lines;
  vtkPolyData* Rays;
  const RayColors& Colors;
  const ColorMap& Map;
  const Projection& Project;
  vtkDataArray* Value;
  vtkDataArray* State;
  vtkDataArray* Breaking;
  vtkDataArray* Lee;
};

}

Rgb stateColor(int state)
{
  switch (static_cast<RayState>(state))
  {
  case RayState::Dead:
    return { 0.35, 0.35, 0.35 };
  case RayState::Flat:
    return { 0.90, 0.62, 0.0 };
  case RayState::Aground:
    return { 0.80, 0.24, 0.10 };
  default:
    return { 0.09, 0.10, 0.22 };
  }
}

namespace
{

vtkDataArray* arrayToColorBy(vtkPointData* data, const std::string& name, const char* what)
{
  vtkDataArray* values = data->GetArray(name.c_str());
  if (values && values->GetNumberOfComponents() == 1)
  {
    return values;
  }
  std::string known;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (array && array->GetNumberOfComponents() == 1)
    {
      known += (known.empty() ? "" : ", ") + std::string(array->GetName());
    }
  }
  throw WorkError(
    fmt::format("the {} {} no array '{}' to colour {} by; {} {}", what, std::string(what) == "map" ? "has" : "have",
      name, std::string(what) == "map" ? "it" : "them", std::string(what) == "map" ? "it has" : "they have", known));
}

// A scale over these values of an array.
RayColors scaleOf(const std::string& name, std::vector<double> values)
{
  RayColors colors;
  colors.kind = RayColors::Kind::Scale;
  const auto known = Names.find(name);
  colors.name = known == Names.end() ? name : known->second.first;
  colors.unit = known == Names.end() ? "" : known->second.second;
  if (values.empty())
  {
    return colors;
  }
  // A few extreme points, at caustics and on the beach, must not take all of the scale.
  const auto percentile = [&](double share)
  {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  colors.range = roundRange(percentile(0.01), percentile(0.99));
  const auto ends = std::minmax_element(values.begin(), values.end());
  colors.below = *ends.first < colors.range.low;
  colors.above = *ends.second > colors.range.high;
  return colors;
}

}

RayColors chooseRayColors(const ChartContent& content)
{
  RayColors colors;
  if (content.map)
  {
    colors.plain = RayOverMapColor; // against every colour of a scale
  }
  if (!content.rays || content.colorBy.empty() || content.rays->GetNumberOfPoints() == 0)
  {
    return colors;
  }
  vtkPointData* data = content.rays->GetPointData();
  vtkDataArray* values = arrayToColorBy(data, content.colorBy, "rays");
  if (content.colorBy == "RayState")
  {
    colors.kind = RayColors::Kind::States;
    return colors;
  }
  vtkDataArray* states = data->GetArray("RayState");
  std::vector<double> shown;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    const bool aground = states && static_cast<int>(states->GetComponent(i, 0)) == static_cast<int>(RayState::Aground);
    if (std::isfinite(value) && !aground)
    {
      shown.push_back(value);
    }
  }
  return scaleOf(content.colorBy, std::move(shown));
}

RayColors chooseMapColors(const ChartContent& content)
{
  vtkDataArray* values = arrayToColorBy(content.map->GetPointData(), content.mapBy, "map");
  std::vector<double> shown;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    if (std::isfinite(values->GetComponent(i, 0)))
    {
      shown.push_back(values->GetComponent(i, 0));
    }
  }
  const bool everywhere = static_cast<vtkIdType>(shown.size()) == values->GetNumberOfTuples();
  RayColors colors = scaleOf(content.mapBy, std::move(shown));
  colors.gaps = !everywhere;
  return colors;
}

ChartLines makeChartLines(const ChartContent& content, const ChartLayout& layout, const RayColors& colors)
{
  ChartLines lines;
  const Projection project(content, layout);
  if (content.contours)
  {
    addContours(lines, content, layout, project);
  }
  if (content.crests)
  {
    addCrests(lines, content, layout, project);
  }
  if (content.rays)
  {
    lines.rayStride = rayStride(content.rays, layout, project);
    RayLinesMaker maker(lines, content, colors, project);
    for (const vtkIdType ray : raysToDraw(content.rays, lines.rayStride))
    {
      maker.add(ray);
    }
  }
  addObstacles(lines, content, project);
  return lines;
}

}
