#include "vtkSwellContours.h"

#include "AlgorithmExecution.h"
#include "ContourLines.h"
#include "FieldData.h"
#include "GeoreferenceField.h"
#include "RayArrays.h"
#include "SeafloorField.h"
#include "bathymetry/SimplifyLines.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkSwellContours);

namespace
{

// More levels than any chart has: an interval that small is a slip of the unit or the comma.
constexpr double MostLevels = 1000.0;
constexpr double LevelsByDefault = 10.0;

double roundInterval(double deepest)
{
  const double least = deepest / LevelsByDefault;
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : { 1.0, 2.0, 5.0 })
  {
    if (factor * decade >= least)
    {
      return factor * decade;
    }
  }
  return 10.0 * decade;
}

std::vector<double> levelsOf(const swellray::ElevationGrid& grid, double waterLevel, double interval)
{
  double lowest = std::numeric_limits<double>::infinity();
  for (const double z : grid.elevation)
  {
    lowest = z < lowest ? z : lowest;
  }
  const double deepest = waterLevel - lowest;
  if (!(deepest > 0.0))
  {
    return {};
  }
  const double step = interval > 0.0 ? interval : roundInterval(deepest);
  const double count = std::floor(deepest / step);
  if (count > MostLevels)
  {
    throw std::invalid_argument("an interval of " + std::to_string(step) + " m gives " +
      std::to_string(static_cast<long long>(count)) + " contour levels down to " + std::to_string(deepest) +
      " m; at most " + std::to_string(static_cast<int>(MostLevels)) + " are drawn: take a larger interval");
  }
  std::vector<double> levels;
  for (int i = 0; i <= static_cast<int>(count); ++i)
  {
    levels.push_back(i * step);
  }
  return levels;
}

void checkAtLeastZero(const char* name, double value)
{
  if (!(value >= 0.0) || !std::isfinite(value))
  {
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) + " m; it must be 0 or more");
  }
}

}

vtkSwellContours::vtkSwellContours()
{
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
}

void vtkSwellContours::AddLevel(double depth)
{
  this->Levels.push_back(depth);
  this->Modified();
}

void vtkSwellContours::ClearLevels()
{
  if (!this->Levels.empty())
  {
    this->Levels.clear();
    this->Modified();
  }
}

int vtkSwellContours::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkSwellContours::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    swellray::dropGeographicGrid(output);
    checkAtLeastZero("Interval", this->Interval);
    checkAtLeastZero("Relief", this->Relief);
    checkAtLeastZero("Simplify", this->Simplify);
    const swellray::ElevationGrid grid = swellray::gridOfImage(input, this->GetInputArrayToProcess(0, inputVector));
    if (grid.columns < 2 || grid.rows < 2)
    {
      throw std::invalid_argument("the seafloor image has " + std::to_string(grid.columns) + " x " +
        std::to_string(grid.rows) + " nodes; contours need at least 2 x 2");
    }
    const std::vector<double> levels =
      this->Levels.empty() ? levelsOf(grid, this->WaterLevel, this->Interval) : this->Levels;

    swellray::LineSet lines;
    std::vector<double> depths;
    const swellray::Execution execution = swellray::makeExecution(this);
    for (std::size_t i = 0; i < levels.size(); ++i)
    {
      if (!std::isfinite(levels[i]))
      {
        throw std::invalid_argument(
          "a contour level is " + std::to_string(levels[i]) + "; it must be a depth in metres");
      }
      swellray::addContourLines(grid, this->WaterLevel - levels[i], this->Relief, lines);
      depths.resize(lines.offsets.size() - 1, levels[i]);
      if (!execution.report(static_cast<double>(i + 1) / static_cast<double>(levels.size())))
      {
        break;
      }
    }
    if (this->Simplify > 0.0)
    {
      lines = swellray::simplifyLines(lines, this->Simplify);
    }

    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(lines.points.size()));
    for (std::size_t i = 0; i < lines.points.size(); ++i)
    {
      points->SetPoint(static_cast<vtkIdType>(i), lines.points[i].x, lines.points[i].y, 0.0);
    }
    output->SetPoints(points);
    output->SetLines(swellray::linesInOrder(lines.offsets));
    double* depth =
      swellray::addArray<vtkDoubleArray>(output->GetCellData(), "Depth", static_cast<vtkIdType>(depths.size()));
    std::copy(depths.begin(), depths.end(), depth);
    swellray::setFieldValue(output, "WaterLevel", this->WaterLevel);
    swellray::addLongitudeLatitude(output);
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkSwellContours::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Levels:";
  for (const double level : this->Levels)
  {
    os << " " << level;
  }
  os << "\n";
  os << indent << "Interval: " << this->Interval << "\n";
  os << indent << "WaterLevel: " << this->WaterLevel << "\n";
  os << indent << "Relief: " << this->Relief << "\n";
  os << indent << "Simplify: " << this->Simplify << "\n";
}
