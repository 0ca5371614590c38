#include "Relief.h"

#include "Scale.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace swellray::drawing
{

namespace
{

// Relief looks flat below this share of the scene's width.
constexpr double ShownRelief = 0.08;

// Nodes that are kept along an axis, always the first and the last.
std::vector<int> keptNodes(int count, int stride)
{
  std::vector<int> kept;
  for (int i = 0; i < count - 1; i += stride)
  {
    kept.push_back(i);
  }
  kept.push_back(count - 1);
  return kept;
}

}

vtkSmartPointer<vtkPolyData> reliefOf(vtkImageData* seafloor, vtkIdType mostNodes)
{
  int size[3];
  seafloor->GetDimensions(size);
  const double* origin = seafloor->GetOrigin();
  const double* spacing = seafloor->GetSpacing();
  vtkDataArray* elevations = seafloor->GetPointData()->GetArray("Elevation");
  const double nodes = static_cast<double>(size[0]) * size[1];
  const int stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(nodes / static_cast<double>(mostNodes)))));
  const std::vector<int> columns = keptNodes(size[0], stride);
  const std::vector<int> rows = keptNodes(size[1], stride);
  const auto width = static_cast<vtkIdType>(columns.size());

  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> elevation;
  elevation->SetName("Elevation");
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  const auto valueAt = [&](int column, int row)
  { return elevations->GetComponent(static_cast<vtkIdType>(row) * size[0] + column, 0); };
  const auto slope = [](double before, double after, double distance)
  {
    const double s = (after - before) / distance;
    return std::isfinite(s) ? s : 0.0;
  };
  for (const int row : rows)
  {
    for (const int column : columns)
    {
      const double z = valueAt(column, row);
      const int west = std::max(0, column - stride);
      const int east = std::min(size[0] - 1, column + stride);
      const int south = std::max(0, row - stride);
      const int north = std::min(size[1] - 1, row + stride);
      const double x = slope(valueAt(west, row), valueAt(east, row), (east - west) * spacing[0]);
      const double y = slope(valueAt(column, south), valueAt(column, north), (north - south) * spacing[1]);
      const double length = std::sqrt(1.0 + x * x + y * y);
      points->InsertNextPoint(
        origin[0] + column * spacing[0], origin[1] + row * spacing[1], std::isfinite(z) ? z : 0.0);
      elevation->InsertNextValue(static_cast<float>(z));
      normals->InsertNextTuple3(-x / length, -y / length, 1.0 / length);
    }
  }
  vtkNew<vtkCellArray> cells;
  for (vtkIdType j = 0; j + 1 < static_cast<vtkIdType>(rows.size()); ++j)
  {
    for (vtkIdType i = 0; i + 1 < width; ++i)
    {
      const vtkIdType corner = j * width + i;
      const vtkIdType quad[4] = { corner, corner + 1, corner + width + 1, corner + width };
      if (std::all_of(quad, quad + 4, [&](vtkIdType id) { return std::isfinite(elevation->GetValue(id)); }))
      {
        cells->InsertNextCell(4, quad);
      }
    }
  }
  auto relief = vtkSmartPointer<vtkPolyData>::New();
  relief->SetPoints(points);
  relief->SetPolys(cells);
  relief->GetPointData()->SetScalars(elevation);
  relief->GetPointData()->SetNormals(normals);
  return relief;
}

double exaggerationFor(double width, double relief)
{
  const double wanted = relief > 0.0 ? ShownRelief * width / relief : 1.0;
  return wanted <= 1.0 ? 1.0 : roundNumber(wanted);
}

}
