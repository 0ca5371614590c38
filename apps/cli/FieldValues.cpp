#include "FieldValues.h"

#include "apps/drawing/Scale.h"

#include <fmt/format.h>

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>

namespace swellray::cli
{

std::optional<double> fieldNumber(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  if (array && array->GetNumberOfTuples() > 0)
  {
    return array->GetComponent(0, 0);
  }
  return {};
}

std::string fieldText(vtkDataObject* data, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
  return array && array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0)) : std::string();
}

void setFieldText(vtkDataObject* data, const char* name, const std::string& text)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  data->GetFieldData()->AddArray(array);
}

std::string waveWords(vtkDataObject* data)
{
  const auto period = fieldNumber(data, "Period");
  const auto direction = fieldNumber(data, "DirectionFrom");
  const auto height = fieldNumber(data, "WaveHeight");
  if (!period || !direction || !height)
  {
    return {};
  }
  const auto depth = fieldNumber(data, "OffshoreDepth");
  return fmt::format("waves of {} s, {} m high, from {}\u00b0 ({}){}", drawing::shortNumber(*period),
    drawing::shortNumber(*height), drawing::shortNumber(0.01 * std::round(100.0 * *direction)),
    drawing::compassPoint(*direction),
    depth && std::isfinite(*depth) ? fmt::format(" in {} m of water", drawing::shortNumber(*depth)) : " in deep water");
}

Georeference georeferenceOf(vtkDataObject* data)
{
  if (fieldText(data, "EarthModel") == "ellipsoid")
  {
    return Georeference::fromMercator(fieldText(data, "CRS"));
  }
  return Georeference(fieldText(data, "CRS"),
    { fieldNumber(data, "OriginLongitude").value_or(0.0), fieldNumber(data, "OriginLatitude").value_or(0.0) },
    { fieldNumber(data, "OriginX").value_or(0.0), fieldNumber(data, "OriginY").value_or(0.0) });
}

std::vector<Obstacle> obstaclesOf(vtkDataObject* data)
{
  vtkFieldData* fields = data->GetFieldData();
  vtkDataArray* points = fields->GetArray("ObstaclePoints");
  vtkDataArray* offsets = fields->GetArray("ObstacleOffsets");
  vtkDataArray* rings = fields->GetArray("ObstacleRings");
  std::vector<Obstacle> obstacles;
  if (!points || points->GetNumberOfComponents() != 2 || !offsets || !rings)
  {
    return obstacles;
  }
  for (vtkIdType i = 0; i + 1 < offsets->GetNumberOfTuples() && i < rings->GetNumberOfTuples(); ++i)
  {
    Obstacle obstacle;
    obstacle.closed = rings->GetComponent(i, 0) != 0.0;
    const auto end = std::min(static_cast<vtkIdType>(offsets->GetComponent(i + 1, 0)), points->GetNumberOfTuples());
    for (auto p = std::max(vtkIdType(0), static_cast<vtkIdType>(offsets->GetComponent(i, 0))); p < end; ++p)
    {
      obstacle.points.emplace_back(points->GetComponent(p, 0), points->GetComponent(p, 1));
    }
    if (!obstacle.points.empty())
    {
      obstacles.push_back(std::move(obstacle));
    }
  }
  return obstacles;
}

}
