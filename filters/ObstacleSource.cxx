#include "ObstacleSource.h"

#include "RayArrays.h"
#include "bathymetry/ObstacleReader.h"

#include <vtkDataObject.h>
#include <vtkFieldData.h>

#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace swellray
{

namespace
{

std::string describeSource(
  const std::string& path, const Georeference& scene, const Rectangle& bounds, double reflection)
{
  std::ostringstream words;
  words << std::hexfloat << path << '\n';
  std::error_code none;
  const auto date = std::filesystem::last_write_time(path, none);
  if (!none)
  {
    words << date.time_since_epoch().count();
  }
  words << '\n'
        << bounds.low.x << ' ' << bounds.low.y << ' ' << bounds.high.x << ' ' << bounds.high.y << ' '
        << scene.originLongitude() << ' ' << scene.originLatitude() << ' ' << scene.originX() << ' ' << scene.originY()
        << ' ' << reflection << '\n'
        << scene.crs();
  return words.str();
}

}

std::shared_ptr<const Obstacles> ObstacleField::get(
  const std::string& path, const Georeference& scene, const Rectangle& bounds, double reflection)
{
  const std::string source = describeSource(path, scene, bounds, reflection);
  if (!this->Kept || this->Source != source)
  {
    this->Kept.reset();
    ObstacleFile file = readObstacles(path, scene, bounds, reflection);
    this->List = std::move(file.obstacles);
    this->Notes = std::move(file.notes);
    this->Kept = std::make_shared<Obstacles>(this->List);
    this->Source = source;
  }
  return this->Kept;
}

void setObstacles(vtkDataObject* data, const std::vector<Obstacle>& obstacles)
{
  vtkFieldData* fields = data->GetFieldData();
  const auto count = static_cast<vtkIdType>(obstacles.size());
  int* offsets = addArray<vtkIntArray>(fields, "ObstacleOffsets", count + 1);
  unsigned char* rings = addArray<vtkUnsignedCharArray>(fields, "ObstacleRings", count);
  double* reflection = addArray<vtkDoubleArray>(fields, "ObstacleReflection", count);
  double* slope = addArray<vtkDoubleArray>(fields, "ObstacleSlope", count);
  offsets[0] = 0;
  for (std::size_t i = 0; i < obstacles.size(); ++i)
  {
    offsets[i + 1] = offsets[i] + static_cast<int>(obstacles[i].points.size());
    rings[i] = obstacles[i].closed ? 1 : 0;
    reflection[i] = obstacles[i].reflection;
    slope[i] = obstacles[i].slope;
  }
  double* points = addArray<vtkDoubleArray>(fields, "ObstaclePoints", offsets[obstacles.size()], 2);
  for (const Obstacle& obstacle : obstacles)
  {
    for (const glm::dvec2& point : obstacle.points)
    {
      *points++ = point.x;
      *points++ = point.y;
    }
  }
}

std::shared_ptr<const Obstacles> obstaclesOf(vtkDataObject* data)
{
  vtkFieldData* fields = data->GetFieldData();
  vtkDataArray* const points = fields->GetArray("ObstaclePoints");
  vtkDataArray* const offsets = fields->GetArray("ObstacleOffsets");
  vtkDataArray* const rings = fields->GetArray("ObstacleRings");
  vtkDataArray* const reflection = fields->GetArray("ObstacleReflection");
  vtkDataArray* const slope = fields->GetArray("ObstacleSlope");
  if (!points && !offsets)
  {
    return nullptr;
  }
  const vtkIdType count = rings ? rings->GetNumberOfTuples() : 0;
  bool fits = points && offsets && rings && reflection && points->GetNumberOfComponents() == 2 &&
    offsets->GetNumberOfTuples() == count + 1 && reflection->GetNumberOfTuples() == count &&
    offsets->GetComponent(0, 0) == 0.0 &&
    offsets->GetComponent(count, 0) == static_cast<double>(points->GetNumberOfTuples());
  std::vector<Obstacle> obstacles(fits ? static_cast<std::size_t>(count) : 0);
  for (vtkIdType i = 0; fits && i < count; ++i)
  {
    Obstacle& obstacle = obstacles[static_cast<std::size_t>(i)];
    const auto end = static_cast<vtkIdType>(offsets->GetComponent(i + 1, 0));
    const auto begin = static_cast<vtkIdType>(offsets->GetComponent(i, 0));
    fits = begin >= 0 && begin <= end && end <= points->GetNumberOfTuples();
    for (vtkIdType p = begin; fits && p < end; ++p)
    {
      obstacle.points.emplace_back(points->GetComponent(p, 0), points->GetComponent(p, 1));
    }
    obstacle.closed = rings->GetComponent(i, 0) != 0.0;
    obstacle.reflection = reflection->GetComponent(i, 0);
    obstacle.slope = slope && i < slope->GetNumberOfTuples() ? slope->GetComponent(i, 0) : 0.0;
  }
  if (!fits)
  {
    throw std::invalid_argument("the field data ObstaclePoints, ObstacleOffsets, ObstacleRings and ObstacleReflection "
                                "of the rays do not fit together; trace them again");
  }
  return std::make_shared<Obstacles>(obstacles);
}

}
