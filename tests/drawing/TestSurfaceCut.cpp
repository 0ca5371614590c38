#include "apps/drawing/SurfaceCut.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace
{

using namespace swellray::drawing;

// A few roundings of numbers of some tens.
constexpr double Rounding = 1e-12;

constexpr int Nodes = 11; // a side, 1 m apart

double planeAt(double x, double y)
{
  return 0.5 + 0.1 * x - 0.2 * y;
}

vtkSmartPointer<vtkPolyData> slopingSheet()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> foam;
  foam->SetName("Foam");
  for (int row = 0; row < Nodes; ++row)
  {
    for (int column = 0; column < Nodes; ++column)
    {
      points->InsertNextPoint(column, row, planeAt(column, row));
      foam->InsertNextValue(0.1 * column);
    }
  }
  vtkNew<vtkCellArray> cells;
  for (vtkIdType row = 0; row + 1 < Nodes; ++row)
  {
    for (vtkIdType column = 0; column + 1 < Nodes; ++column)
    {
      const vtkIdType at = row * Nodes + column;
      cells->InsertNextCell({ at, at + 1, at + Nodes + 1 });
      cells->InsertNextCell({ at, at + Nodes + 1, at + Nodes });
    }
  }
  auto sheet = vtkSmartPointer<vtkPolyData>::New();
  sheet->SetPoints(points);
  sheet->SetPolys(cells);
  sheet->GetPointData()->AddArray(foam);
  return sheet;
}

void expectWholeCut(const CutLine& line, double covered)
{
  const glm::dvec2 forward = (line.to - line.from) / line.length();
  std::map<std::pair<long, long>, int> ends;
  double length = 0.0;
  for (const CutSegment& segment : cutSurface(slopingSheet(), line))
  {
    for (const glm::dvec2& end : { segment.begin, segment.end })
    {
      const glm::dvec2 place = line.from + end.x * forward;
      EXPECT_NEAR(end.y, planeAt(place.x, place.y), Rounding);
      ++ends[{ std::lround(1e9 * end.x), std::lround(1e9 * end.y) }];
    }
    length += std::abs(segment.end.x - segment.begin.x);
    const double middle = line.from.x + 0.5 * (segment.begin.x + segment.end.x) * forward.x;
    EXPECT_NEAR(segment.foam, 0.1 * middle, Rounding);
  }
  EXPECT_NEAR(length, covered, 1e3 * Rounding);
  int open = 0;
  for (const auto& end : ends)
  {
    open += end.second % 2;
  }
  EXPECT_EQ(open, 2) << "a cut begins and ends at the edges of the sheet and nowhere else";
}

TEST(SurfaceCut, isOnTheSurfaceAndWithoutGaps)
{
  expectWholeCut({ { -1.0, 3.3 }, { 12.0, 3.3 } }, 10.0);
  expectWholeCut({ { 0.0, 0.37 }, { 10.0, 9.41 } }, std::hypot(10.0, 9.04));
}

TEST(SurfaceCut, goesAlongEdgesOfTriangles)
{
  expectWholeCut({ { 0.0, 4.0 }, { 10.0, 4.0 } }, 10.0);
  expectWholeCut({ { 10.0, 10.0 }, { 0.0, 0.0 } }, std::hypot(10.0, 10.0));
}

TEST(SurfaceCut, needsALine)
{
  EXPECT_THROW(cutSurface(slopingSheet(), { { 1.0, 2.0 }, { 1.0, 2.0 } }), std::invalid_argument);
}

TEST(SurfaceCut, takesTheSeafloorBetweenItsNodes)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(Nodes, Nodes, 1);
  image->SetOrigin(100.0, 50.0, 0.0);
  image->SetSpacing(2.0, 3.0, 1.0);
  vtkNew<vtkDoubleArray> elevation;
  elevation->SetName("Elevation");
  for (int row = 0; row < Nodes; ++row)
  {
    for (int column = 0; column < Nodes; ++column)
    {
      elevation->InsertNextValue(planeAt(100.0 + 2.0 * column, 50.0 + 3.0 * row));
    }
  }
  elevation->SetValue(0, std::numeric_limits<double>::quiet_NaN());
  image->GetPointData()->AddArray(elevation);
  // From the last corner to beyond the first, whose node has no value.
  const CutLine line{ { 120.0, 80.0 }, { 98.0, 47.0 } };
  const auto values = cutSeafloor(image, line, 12);
  ASSERT_EQ(values.size(), 12u);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const glm::dvec2 place = line.from + (static_cast<double>(i) / 11.0) * (line.to - line.from);
    if (i < 10)
    {
      EXPECT_NEAR(values[i], planeAt(place.x, place.y), 1e2 * Rounding) << i;
    }
    else
    {
      EXPECT_TRUE(std::isnan(values[i])) << i;
    }
  }
}

}
