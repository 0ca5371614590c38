#include "RayLines.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace swellray::scene
{

namespace
{

// A line leaves out points that are closer to it than this share of the scene's width: less than a pixel of the whole.
constexpr double Unseen = 1.0 / 4000.0;

double distanceToLine(const double* p, const double* a, const double* b)
{
  const double x = b[0] - a[0];
  const double y = b[1] - a[1];
  const double length = std::hypot(x, y);
  const double u = p[0] - a[0];
  const double v = p[1] - a[1];
  return length > 0.0 ? std::abs(x * v - y * u) / length : std::hypot(u, v);
}

// The points that are kept: each as far from the one before as all points between lie on their straight line.
std::vector<vtkIdType> bendsOf(vtkPoints* points, const vtkIdType* ids, vtkIdType count, double tolerance)
{
  std::vector<vtkIdType> kept{ ids[0] };
  vtkIdType first = 0;
  for (vtkIdType last = 2; last < count; ++last)
  {
    double a[3];
    double b[3];
    points->GetPoint(ids[first], a);
    points->GetPoint(ids[last], b);
    for (vtkIdType i = first + 1; i < last; ++i)
    {
      double p[3];
      points->GetPoint(ids[i], p);
      if (distanceToLine(p, a, b) > tolerance)
      {
        first = last - 1;
        kept.push_back(ids[first]);
        break;
      }
    }
  }
  kept.push_back(ids[count - 1]);
  return kept;
}

}

vtkSmartPointer<vtkPolyData> rayLines(vtkPolyData* rays, double height)
{
  double bounds[6];
  rays->GetBounds(bounds);
  const double tolerance = Unseen * std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  const vtkIdType count = rays->GetNumberOfLines();
  const vtkIdType stride = std::max<vtkIdType>(1, (count + MostRayLines - 1) / MostRayLines);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (vtkIdType ray = 0; ray < count; ray += stride)
  {
    vtkIdType length = 0;
    const vtkIdType* ids = nullptr;
    rays->GetLines()->GetCellAtId(ray, length, ids);
    if (length < 2)
    {
      continue;
    }
    const std::vector<vtkIdType> bends = bendsOf(rays->GetPoints(), ids, length, tolerance);
    lines->InsertNextCell(static_cast<vtkIdType>(bends.size()));
    for (const vtkIdType id : bends)
    {
      double p[3];
      rays->GetPoint(id, p);
      lines->InsertCellPoint(points->InsertNextPoint(p[0], p[1], height));
    }
  }
  auto drawn = vtkSmartPointer<vtkPolyData>::New();
  drawn->SetPoints(points);
  drawn->SetLines(lines);
  return drawn;
}

}
