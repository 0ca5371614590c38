#include "Observers.h"

#include "vtkSwellContours.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>

#include <glm/vec2.hpp>

#include <cmath>
#include <set>

namespace
{

// Positions a million metres from the origin in double precision: a few roundings.
constexpr double PositionTolerance = 1e-8;

std::vector<glm::dvec2> lineOf(vtkPolyData* lines, vtkIdType cell)
{
  vtkIdType size = 0;
  const vtkIdType* points = nullptr;
  lines->GetLines()->GetCellAtId(cell, size, points);
  std::vector<glm::dvec2> result;
  for (vtkIdType i = 0; i < size; ++i)
  {
    const double* p = lines->GetPoint(points[i]);
    result.emplace_back(p[0], p[1]);
  }
  return result;
}

// Twice the signed area: positive anticlockwise.
double turning(const std::vector<glm::dvec2>& line)
{
  double area = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    area += line[i].x * line[i + 1].y - line[i + 1].x * line[i].y;
  }
  return area;
}

double depthOf(vtkPolyData* lines, vtkIdType cell)
{
  return lines->GetCellData()->GetArray("Depth")->GetComponent(cell, 0);
}

// Deeper to the east by 1 m in 50, depth 0 at x = x0.
vtkSmartPointer<vtkImageData> beach(double x0)
{
  return elevationImage(
    31, 21, 10.0, [=](double x, double) { return -0.02 * (x - x0); }, x0 - 50.0, 2.0e6);
}

}

TEST(Contours, lieOnAPlaneWithShallowerWaterOnTheLeft)
{
  const double x0 = 1.0e6;
  vtkNew<vtkSwellContours> contours;
  contours->SetInputData(beach(x0));
  contours->AddLevel(1.1);
  contours->AddLevel(3.0);
  contours->Update();
  vtkPolyData* lines = contours->GetOutput();
  ASSERT_EQ(lines->GetNumberOfCells(), 2);
  ASSERT_EQ(lines->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    const double depth = depthOf(lines, cell);
    EXPECT_EQ(depth, cell == 0 ? 1.1 : 3.0);
    const std::vector<glm::dvec2> line = lineOf(lines, cell);
    ASSERT_EQ(line.size(), 21u);
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      EXPECT_NEAR(line[i].x, x0 + 50.0 * depth, PositionTolerance);
      // Shallower water is in the west: with it on the left the line goes north.
      EXPECT_NEAR(line[i].y, 2.0e6 + 10.0 * static_cast<double>(i), PositionTolerance);
    }
  }
}

TEST(Contours, moveWithTheTide)
{
  vtkNew<vtkSwellContours> contours;
  contours->SetInputData(beach(0.0));
  contours->AddLevel(3.0);
  contours->SetWaterLevel(1.0);
  contours->Update();
  ASSERT_EQ(contours->GetOutput()->GetNumberOfCells(), 1);
  EXPECT_NEAR(contours->GetOutput()->GetPoint(0)[0], 100.0, PositionTolerance);
  EXPECT_EQ(contours->GetOutput()->GetFieldData()->GetArray("WaterLevel")->GetComponent(0, 0), 1.0);
}

TEST(Contours, closeAroundAShoalAndAHollow)
{
  for (const double sign : { 1.0, -1.0 })
  {
    vtkNew<vtkSwellContours> contours;
    contours->SetInputData(elevationImage(
      61, 61, 10.0, [=](double x, double y) { return -20.0 + sign * 8.0 * std::exp(-(x * x + y * y) / 2e4); }, -300.0,
      -300.0));
    contours->AddLevel(20.0 - sign * 4.0);
    contours->Update();
    ASSERT_EQ(contours->GetOutput()->GetNumberOfCells(), 1);
    const std::vector<glm::dvec2> line = lineOf(contours->GetOutput(), 0);
    EXPECT_EQ(line.front(), line.back());
    // Shallower inside: anticlockwise; shallower outside: clockwise.
    EXPECT_GT(sign * turning(line), 0.0);
    for (const glm::dvec2& p : line)
    {
      // Linear between nodes 10 m apart over a curvature of 8 m/1e4 m2: 1 cm of depth, 20 cm of distance.
      EXPECT_NEAR(std::hypot(p.x, p.y), std::sqrt(2e4 * std::log(2.0)), 0.2);
    }
  }
}

TEST(Contours, endAtHoles)
{
  const vtkSmartPointer<vtkImageData> image = beach(0.0);
  // The contour at 1.1 m passes x = 55 m, between columns 10 and 11; row 7 has no elevation there.
  const int node[3] = { 11, 7, 0 };
  image->GetPointData()->GetScalars()->SetComponent(image->ComputePointId(const_cast<int*>(node)), 0, std::nan(""));
  vtkNew<vtkSwellContours> contours;
  contours->SetInputData(image);
  contours->AddLevel(1.1);
  contours->Update();
  ASSERT_EQ(contours->GetOutput()->GetNumberOfCells(), 2);
  std::vector<double> ends;
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    const std::vector<glm::dvec2> line = lineOf(contours->GetOutput(), cell);
    for (const glm::dvec2& p : line)
    {
      EXPECT_NEAR(p.x, 55.0, PositionTolerance);
      EXPECT_FALSE(p.y > 2.0e6 + 60.0 && p.y < 2.0e6 + 80.0) << p.y;
    }
    ends.push_back(line.front().y - 2.0e6);
    ends.push_back(line.back().y - 2.0e6);
  }
  EXPECT_THAT(ends, testing::UnorderedElementsAre(0.0, 60.0, 80.0, 200.0));
}

TEST(Contours, passThroughNodesOfJustThatDepthOnce)
{
  vtkNew<vtkSwellContours> contours;
  contours->SetInputData(beach(0.0));
  contours->AddLevel(0.0); // at a column of nodes
  contours->Update();
  ASSERT_EQ(contours->GetOutput()->GetNumberOfCells(), 1);
  const std::vector<glm::dvec2> line = lineOf(contours->GetOutput(), 0);
  EXPECT_EQ(line.size(), 21u);
}

TEST(Contours, takeTheMultiplesOfAnIntervalFromTheShoreline)
{
  vtkNew<vtkSwellContours> contours;
  contours->SetInputData(beach(0.0)); // 5 m deep, 1 m high
  const auto depths = [&]
  {
    contours->Update();
    std::set<double> found;
    for (vtkIdType cell = 0; cell < contours->GetOutput()->GetNumberOfCells(); ++cell)
    {
      found.insert(depthOf(contours->GetOutput(), cell));
    }
    return found;
  };
  contours->SetInterval(1.5);
  EXPECT_EQ(depths(), (std::set<double>{ 0.0, 1.5, 3.0, 4.5 }));
  // Nothing is deeper than 5 m: no line has deeper water on its right there.
  contours->SetInterval(0.0);
  EXPECT_EQ(depths(), (std::set<double>{ 0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5 }));
}

TEST(Contours, leaveOutPointsOnDemand)
{
  vtkNew<vtkSwellContours> contours;
  contours->SetInputData(beach(0.0));
  contours->AddLevel(1.1);
  contours->SetSimplify(1.0);
  contours->Update();
  ASSERT_EQ(contours->GetOutput()->GetNumberOfCells(), 1);
  EXPECT_EQ(contours->GetOutput()->GetNumberOfPoints(), 2);
}

TEST(Contours, runAlongTheEdgeOfAFlatOfJustThatLevel)
{
  // A beach to x = 100, a flat of elevation 0 with rings of millimetres to x = 200, land behind.
  const auto bed = [](double x, double y)
  {
    const double ring = 0.004 * std::cos(0.7 * x) * std::cos(0.9 * y);
    return x < 100.0 ? -0.02 * (100.0 - x) : x <= 200.0 ? ring : 0.05 * (x - 200.0);
  };
  const auto linesOf = [&](double relief)
  {
    vtkNew<vtkSwellContours> contours;
    contours->SetInputData(elevationImage(31, 31, 10.0, bed));
    contours->AddLevel(0.0);
    contours->SetRelief(relief);
    contours->Update();
    return vtkSmartPointer<vtkPolyData>(contours->GetOutput());
  };
  EXPECT_GT(linesOf(0.0)->GetNumberOfCells(), 20) << "a line around every ring";
  const vtkSmartPointer<vtkPolyData> lines = linesOf(0.02);
  ASSERT_EQ(lines->GetNumberOfCells(), 1);
  for (const glm::dvec2& p : lineOf(lines, 0))
  {
    // One cell around where the flat begins.
    EXPECT_NEAR(p.x, 100.0, 10.0);
  }
}

TEST(Contours, areTheSameWithAndWithoutReliefWhereNothingIsFlat)
{
  const auto linesOf = [](double relief)
  {
    vtkNew<vtkSwellContours> contours;
    contours->SetInputData(
      elevationImage(61, 61, 10.0, [](double x, double y) { return 4.0 * std::sin(0.011 * x) * std::cos(0.013 * y); }));
    contours->AddLevel(1.0);
    contours->SetRelief(relief);
    contours->Update();
    return vtkSmartPointer<vtkPolyData>(contours->GetOutput());
  };
  const vtkSmartPointer<vtkPolyData> plain = linesOf(0.0);
  const vtkSmartPointer<vtkPolyData> smooth = linesOf(0.02);
  ASSERT_GT(plain->GetNumberOfPoints(), 50);
  ASSERT_EQ(plain->GetNumberOfPoints(), smooth->GetNumberOfPoints());
  for (vtkIdType i = 0; i < plain->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(plain->GetPoint(i)[0], smooth->GetPoint(i)[0]);
  }
}

TEST(Contours, sayWhatIsWrongOnce)
{
  const auto errorOf = [](vtkImageData* image, const std::function<void(vtkSwellContours*)>& set)
  {
    vtkNew<vtkSwellContours> contours;
    vtkNew<Listener> listener;
    listener->listenTo(contours);
    vtkNew<Listener> quiet;
    quiet->listenTo(contours->GetExecutive());
    contours->SetInputData(image);
    set(contours);
    contours->Update();
    EXPECT_EQ(listener->Errors.size(), 1u);
    EXPECT_EQ(contours->GetOutput()->GetNumberOfCells(), 0);
    return listener->Errors.empty() ? std::string() : listener->Errors.front();
  };
  const auto nothing = [](vtkSwellContours*) {};
  EXPECT_THAT(
    errorOf(beach(0.0), [](vtkSwellContours* c) { c->SetInterval(-1.0); }), testing::HasSubstr("Interval is -1"));
  EXPECT_THAT(errorOf(beach(0.0), [](vtkSwellContours* c) { c->SetRelief(-1.0); }), testing::HasSubstr("Relief is -1"));
  EXPECT_THAT(
    errorOf(beach(0.0), [](vtkSwellContours* c) { c->SetInterval(1e-6); }), testing::HasSubstr("contour levels"));
  EXPECT_THAT(
    errorOf(beach(0.0), [](vtkSwellContours* c) { c->AddLevel(std::nan("")); }), testing::HasSubstr("contour level"));
  EXPECT_THAT(errorOf(vtkNew<vtkImageData>(), nothing), testing::HasSubstr("nodes"));
  EXPECT_THAT(
    errorOf(elevationImage(1, 5, 1.0, [](double, double) { return -1.0; }), nothing), testing::HasSubstr("2 x 2"));
  const vtkSmartPointer<vtkImageData> unnamed = beach(0.0);
  unnamed->GetPointData()->GetScalars()->SetName("Depth");
  EXPECT_THAT(errorOf(unnamed, nothing), testing::HasSubstr("Elevation"));
}
