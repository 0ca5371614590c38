#include "bathymetry/ObstacleReader.h"

#include "bathymetry/QuietGdal.h"
#include "bathymetry/Text.h"
#include "bathymetry/VectorPlaces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>

#include <ogrsf_frmts.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace swellray
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Ring = CGAL::Polygon_2<Kernel>;

// Points nearer than this to the straight wall through their neighbours are left out, m.
constexpr double Straight = 1e-6;

constexpr const char* ReflectionProperty = "reflection";
constexpr const char* SlopeProperty = "slope";

double distanceToLine(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b)
{
  const glm::dvec2 along = b - a;
  const double length = glm::length(along);
  return length > 0.0 ? std::abs(along.x * (p.y - a.y) - along.y * (p.x - a.x)) / length : glm::distance(p, a);
}

// Without repeated points, and without those on a straight wall.
std::vector<glm::dvec2> cleaned(const std::vector<glm::dvec2>& points, bool closed)
{
  std::vector<glm::dvec2> distinct;
  for (const glm::dvec2& point : points)
  {
    if (distinct.empty() || glm::distance(point, distinct.back()) > Straight)
    {
      distinct.push_back(point);
    }
  }
  while (closed && distinct.size() > 1 && glm::distance(distinct.front(), distinct.back()) <= Straight)
  {
    distinct.pop_back();
  }
  std::vector<glm::dvec2> kept;
  const std::size_t count = distinct.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool end = !closed && (i == 0 || i + 1 == count);
    const glm::dvec2& before = kept.empty() ? distinct[(i + count - 1) % count] : kept.back();
    const glm::dvec2& after = distinct[(i + 1) % count];
    // Where the wall turns back on itself the point is its tip.
    const bool onward = glm::dot(distinct[i] - before, after - distinct[i]) > 0.0;
    if (end || !onward || distanceToLine(distinct[i], before, after) > Straight)
    {
      kept.push_back(distinct[i]);
    }
  }
  return kept;
}

bool near(const std::vector<glm::dvec2>& points, const Rectangle& scene)
{
  glm::dvec2 low = points.front();
  glm::dvec2 high = points.front();
  for (const glm::dvec2& point : points)
  {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  return low.x <= scene.high.x && scene.low.x <= high.x && low.y <= scene.high.y && scene.low.y <= high.y;
}

class Reader
{
public:
  Reader(const Georeference& georeference, const Rectangle& scene, double reflection)
    : Place(georeference)
    , Scene(scene)
    , Standard(reflection)
  {
  }

  void read(GDALDataset& dataset)
  {
    for (OGRLayer* layer : dataset.GetLayers())
    {
      this->Place.enter(*layer);
      for (const auto& feature : *layer)
      {
        this->addFeature(*feature);
      }
    }
    if (QuietGdal::failed())
    {
      throw std::runtime_error(QuietGdal::lastError("it is damaged"));
    }
  }

  ObstacleFile finish()
  {
    if (this->Shapes == 0)
    {
      throw std::runtime_error(
        this->Points > 0 ? "it has only points; obstacles are polygons or lines" : "it has no polygons and no lines");
    }
    if (this->File.obstacles.empty())
    {
      throw std::runtime_error("none of its " + std::to_string(this->Shapes) +
        " polygons and lines comes near the scene; is it in another coordinate reference system?");
    }
    const auto note = [this](std::size_t count, const std::string& words)
    {
      if (count > 0)
      {
        this->File.notes.push_back(std::to_string(count) + words);
      }
    };
    note(this->Points, " points of the obstacles are passed over: obstacles are polygons or lines");
    note(this->Outside, " obstacles lie outside of the scene");
    note(this->Crossed, " rings of obstacles cross themselves: land is where they wind around");
    note(this->Empty, " obstacles have no size");
    if (this->Place.unplaced())
    {
      this->File.notes.emplace_back(
        "no CRS on both sides: the obstacles are taken in the coordinates of the scene's file");
    }
    return std::move(this->File);
  }

private:
  // A property from 0 to `most`; none where the feature has none.
  static std::optional<double> numberOf(
    const OGRFeature& feature, const char* property, double most, const std::string& range)
  {
    const int field = feature.GetFieldIndex(property);
    if (field < 0 || !feature.IsFieldSetAndNotNull(field))
    {
      return {};
    }
    const double value = feature.GetFieldAsDouble(field);
    if (!(value >= 0.0 && value <= most))
    {
      throw std::runtime_error("feature " + std::to_string(feature.GetFID()) + ": its property " + property +
        " must be " + range + ", not '" + feature.GetFieldAsString(field) + "'");
    }
    return value;
  }

  void addFeature(const OGRFeature& feature)
  {
    const OGRGeometry* geometry = feature.GetGeometryRef();
    if (!geometry)
    {
      return;
    }
    this->Reflection = numberOf(feature, ReflectionProperty, 1.0, "0 to 1").value_or(this->Standard);
    this->Slope =
      numberOf(feature, SlopeProperty, std::numeric_limits<double>::max(), "0 (vertical) or above").value_or(0.0);
    const std::unique_ptr<OGRGeometry> straight(geometry->getLinearGeometry());
    this->addGeometry(*straight);
  }

  void addGeometry(const OGRGeometry& geometry)
  {
    switch (wkbFlatten(geometry.getGeometryType()))
    {
    case wkbPoint:
      ++this->Points;
      break;
    case wkbLineString:
    case wkbLinearRing:
      this->addLine(*geometry.toLineString());
      break;
    case wkbPolygon:
    case wkbTriangle:
      this->addPolygon(*geometry.toPolygon());
      break;
    case wkbMultiPoint:
      this->Points += static_cast<std::size_t>(geometry.toMultiPoint()->getNumGeometries());
      break;
    case wkbMultiLineString:
    case wkbMultiPolygon:
    case wkbGeometryCollection:
      for (const OGRGeometry* part : *geometry.toGeometryCollection())
      {
        this->addGeometry(*part);
      }
      break;
    default:
      throw std::runtime_error(std::string("geometries of the kind '") + geometry.getGeometryName() +
        "' are no obstacles; they are polygons or lines");
    }
  }

  void addLine(const OGRLineString& line)
  {
    ++this->Shapes;
    const std::vector<glm::dvec2> points = cleaned(this->Place.metresOf(line), false);
    if (points.size() < 2)
    {
      ++this->Empty;
    }
    else if (!near(points, this->Scene))
    {
      ++this->Outside;
    }
    else
    {
      this->File.obstacles.push_back({ points, false, this->Reflection, this->Slope });
    }
  }

  void addPolygon(const OGRPolygon& polygon)
  {
    ++this->Shapes;
    bool outer = true;
    for (const OGRLinearRing* line : polygon)
    {
      const std::vector<glm::dvec2> points = cleaned(this->Place.metresOf(*line), true);
      Ring ring;
      for (const glm::dvec2& point : points)
      {
        ring.push_back(Kernel::Point_2(point.x, point.y));
      }
      const bool simple = ring.size() >= 3 && ring.is_simple();
      if (ring.size() < 3 || (simple && ring.orientation() == CGAL::COLLINEAR))
      {
        ++this->Empty;
        if (outer)
        {
          return;
        }
        continue;
      }
      if (!near(points, this->Scene))
      {
        this->Outside += outer ? 1 : 0;
        if (outer)
        {
          return;
        }
        continue;
      }
      this->Crossed += simple ? 0 : 1;
      const bool anticlockwise = simple ? ring.orientation() == CGAL::COUNTERCLOCKWISE : ring.area() > 0.0;
      if (anticlockwise != outer)
      {
        ring.reverse_orientation();
      }
      Obstacle obstacle;
      obstacle.closed = true;
      obstacle.reflection = this->Reflection;
      obstacle.slope = this->Slope;
      for (const Kernel::Point_2& point : ring.container())
      {
        obstacle.points.emplace_back(point.x(), point.y());
      }
      this->File.obstacles.push_back(std::move(obstacle));
      outer = false;
    }
  }

  VectorPlaces Place;
  Rectangle Scene;
  double Standard;
  double Reflection = 0.0;
  double Slope = 0.0;
  ObstacleFile File;
  std::size_t Shapes = 0;
  std::size_t Points = 0;
  std::size_t Outside = 0;
  std::size_t Crossed = 0;
  std::size_t Empty = 0;
};

}

ObstacleFile readObstacles(
  const std::string& path, const Georeference& georeference, const Rectangle& scene, double reflection)
{
  if (!(reflection >= 0.0 && reflection <= 1.0))
  {
    throw std::invalid_argument("reflection must be 0 to 1, not " + text(reflection));
  }
  const QuietGdal quiet;
  try
  {
    const VectorDataset dataset = openVectors(path);
    Reader reader(georeference, scene, reflection);
    reader.read(*dataset);
    return reader.finish();
  }
  catch (const std::runtime_error& error)
  {
    throw std::runtime_error(oneLine("obstacles '" + path + "': " + error.what()));
  }
}

}
