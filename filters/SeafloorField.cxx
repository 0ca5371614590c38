#include "SeafloorField.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "GeoreferenceField.h"
#include "RayArrays.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/GeographicSeafloor.h"
#include "sim/SplineSeafloor.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>

#include <glm/common.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

namespace swellray
{

namespace
{

// An image that was written and read back has the same doubles; a formula may be compiled differently.
constexpr double FormTolerance = 1e-9;

constexpr const char* GeographicElevation = "GeographicElevation";
constexpr const char* GeographicGrid = "GeographicGrid";
constexpr int LayoutSize = 6;

/** Another seafloor within smaller bounds. */
class CroppedSeafloor final : public Seafloor
{
public:
  CroppedSeafloor(std::shared_ptr<const Seafloor> whole, const Rectangle& bounds)
    : Whole(std::move(whole))
    , Bounds(bounds)
  {
  }

  Rectangle bounds() const override { return this->Bounds; }
  void evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const override
  {
    this->Whole->evaluate(p, region, bed);
  }
  double featureLength() const override { return this->Whole->featureLength(); }
  double resolution() const override { return this->Whole->resolution(); }
  double cellSize() const override { return this->Whole->cellSize(); }
  unsigned kinkCount() const override { return this->Whole->kinkCount(); }
  double kinkLevel(unsigned i, const glm::dvec2& p, glm::dvec2& gradient) const override
  {
    return this->Whole->kinkLevel(i, p, gradient);
  }
  bool hasHoles() const override { return this->Whole->hasHoles(); }
  bool isHole(const glm::dvec2& p) const override { return this->Whole->isHole(p); }
  double highestElevation(const Rectangle& box) const override { return this->Whole->highestElevation(box); }
  double lowestElevation(const Rectangle& box) const override { return this->Whole->lowestElevation(box); }

private:
  std::shared_ptr<const Seafloor> Whole;
  Rectangle Bounds;
};

Rectangle boundsOfImage(vtkImageData* image)
{
  double bounds[6];
  image->GetBounds(bounds);
  return { { bounds[0], bounds[2] }, { bounds[1], bounds[3] } };
}

bool near(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& size)
{
  return std::abs(a.x - b.x) <= FormTolerance * size.x && std::abs(a.y - b.y) <= FormTolerance * size.y;
}

bool hasElevations(const Seafloor& seafloor, const ElevationGrid& grid)
{
  std::atomic<bool> same{ true };
  parallelFor(grid.rows,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t row = begin; row < end && same; ++row)
      {
        for (std::size_t column = 0; column < grid.columns; ++column)
        {
          const double z = seafloor.elevation(grid.node(column, row));
          // A hole of the grid is one of the function too, up to rounding at its edge.
          if (std::abs(z - grid.at(column, row)) > FormTolerance * (1.0 + std::abs(z)))
          {
            same = false;
          }
        }
      }
    });
  return same;
}

}

ElevationGrid gridOfImage(vtkImageData* image, vtkDataArray* elevation)
{
  const int* size = image->GetDimensions();
  if (size[0] < 1 || size[1] < 1 || size[2] != 1)
  {
    throw std::invalid_argument("the seafloor image has " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      " x " + std::to_string(size[2]) + " nodes; it must have one layer of at least 4 x 4");
  }
  if (!image->GetDirectionMatrix()->IsIdentity())
  {
    throw std::invalid_argument("the axes of the seafloor image are turned; they must point east and north");
  }
  const vtkIdType nodes = image->GetNumberOfPoints();
  if (!elevation || elevation->GetNumberOfComponents() != 1 || elevation->GetNumberOfTuples() != nodes)
  {
    throw std::invalid_argument("the input image has no point array Elevation of one component");
  }
  ElevationGrid grid;
  grid.columns = static_cast<std::size_t>(size[0]);
  grid.rows = static_cast<std::size_t>(size[1]);
  grid.origin = boundsOfImage(image).low;
  grid.spacing = { image->GetSpacing()[0], image->GetSpacing()[1] };
  if (auto* doubles = vtkDoubleArray::FastDownCast(elevation))
  {
    grid.elevation.assign(doubles->GetPointer(0), doubles->GetPointer(0) + nodes);
  }
  else
  {
    vtkNew<vtkDoubleArray> copy;
    copy->DeepCopy(elevation);
    grid.elevation.assign(copy->GetPointer(0), copy->GetPointer(0) + nodes);
  }
  return grid;
}

void setGeographicGrid(vtkImageData* image, const ElevationGrid& grid)
{
  double* elevation =
    addArray<vtkDoubleArray>(image->GetFieldData(), GeographicElevation, static_cast<vtkIdType>(grid.elevation.size()));
  std::copy(grid.elevation.begin(), grid.elevation.end(), elevation);
  double* layout = addArray<vtkDoubleArray>(image->GetFieldData(), GeographicGrid, LayoutSize);
  const double values[LayoutSize] = { static_cast<double>(grid.columns), static_cast<double>(grid.rows), grid.origin.x,
    grid.origin.y, grid.spacing.x, grid.spacing.y };
  std::copy_n(values, LayoutSize, layout);
}

std::optional<ElevationGrid> geographicGridOf(vtkImageData* image)
{
  auto* elevation = vtkDoubleArray::FastDownCast(image->GetFieldData()->GetArray(GeographicElevation));
  vtkDataArray* layout = image->GetFieldData()->GetArray(GeographicGrid);
  if (!elevation || !layout || layout->GetNumberOfTuples() != LayoutSize || elevation->GetNumberOfComponents() != 1 ||
    layout->GetComponent(0, 0) * layout->GetComponent(1, 0) != static_cast<double>(elevation->GetNumberOfTuples()))
  {
    return {};
  }
  ElevationGrid grid;
  grid.columns = static_cast<std::size_t>(layout->GetComponent(0, 0));
  grid.rows = static_cast<std::size_t>(layout->GetComponent(1, 0));
  grid.origin = { layout->GetComponent(2, 0), layout->GetComponent(3, 0) };
  grid.spacing = { layout->GetComponent(4, 0), layout->GetComponent(5, 0) };
  grid.elevation.assign(elevation->GetPointer(0), elevation->GetPointer(0) + elevation->GetNumberOfTuples());
  return grid;
}

void dropGeographicGrid(vtkDataObject* data)
{
  data->GetFieldData()->RemoveArray(GeographicElevation);
  data->GetFieldData()->RemoveArray(GeographicGrid);
}

std::shared_ptr<const Seafloor> SeafloorField::get(vtkImageData* image, vtkDataArray* elevation)
{
  const std::string form = fieldString(image, "SeafloorForm").value_or("");
  const Rectangle bounds = boundsOfImage(image);
  if (this->Kept && elevation && elevation == this->Elevation && elevation->GetMTime() == this->ElevationTime &&
    bounds.low == this->Bounds.low && bounds.high == this->Bounds.high && form == this->Form)
  {
    return this->Kept;
  }
  this->Kept.reset();
  const ElevationGrid grid = gridOfImage(image, elevation);
  std::shared_ptr<const Seafloor> result;
  if (!form.empty())
  {
    // A filter in between hands the name of the form on, whatever it does to the elevations.
    const std::shared_ptr<const Seafloor> formula = makeBuiltinSeafloor(form);
    const Rectangle whole = formula->bounds();
    if (near(bounds.low, whole.low, whole.size()) && near(bounds.high, whole.high, whole.size()))
    {
      result = hasElevations(*formula, grid) ? formula : nullptr;
    }
    else if (whole.contains(bounds.low) && whole.contains(bounds.high) && hasElevations(*formula, grid))
    {
      result = std::make_shared<CroppedSeafloor>(formula, bounds);
    }
  }
  const std::shared_ptr<const EllipsoidMercator> map = georeferenceOf(image).mercator();
  if (const auto geographic = map ? geographicGridOf(image) : std::nullopt)
  {
    const auto exact = std::make_shared<GeographicSeafloor>(*geographic, map);
    const Rectangle whole = exact->bounds();
    const bool same = near(bounds.low, whole.low, whole.size()) && near(bounds.high, whole.high, whole.size());
    if (same && hasElevations(*exact, grid))
    {
      result = exact;
    }
  }
  if (!result)
  {
    result = std::make_shared<SplineSeafloor>(grid);
  }
  this->Kept = result;
  this->Elevation = elevation;
  this->ElevationTime = elevation->GetMTime();
  this->Bounds = bounds;
  this->Form = form;
  return this->Kept;
}

}
