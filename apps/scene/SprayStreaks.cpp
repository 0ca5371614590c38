#include "SprayStreaks.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace swellray::scene
{

namespace
{

// Each particle stands for a wisp of them, which is seen where one would not be.
constexpr double LeastOpacity = 0.25;
constexpr double MostOpacity = 0.85;

vtkSmartPointer<vtkFloatArray> arrayOf(const char* name, int components)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  return array;
}

}

vtkSmartPointer<vtkPolyData> streaksOf(vtkPolyData* spray, const StreakView& view)
{
  const glm::dvec3 eye(view.eye[0], view.eye[1], view.eye[2]);
  vtkDataArray* velocities = spray->GetPointData()->GetArray("Velocity");
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  const auto normals = arrayOf("Normals", 3);
  const auto opacity = arrayOf("Opacity", 1);
  const auto across = arrayOf("Across", 1);
  const auto along = arrayOf("Along", 1);
  for (vtkIdType i = 0; i < spray->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 place;
    spray->GetPoint(i, &place.x);
    glm::dvec3 velocity;
    velocities->GetTuple(i, &velocity.x);
    const double distance = glm::length(eye - place);
    if (!(distance > 0.0))
    {
      continue;
    }
    const glm::dvec3 towards = (eye - place) / distance;
    // As the eye sees it: what goes towards it is a dot.
    const glm::dvec3 way = view.exposure * (velocity - glm::dot(velocity, towards) * towards);
    const double length = glm::length(way);
    const glm::dvec3 any = glm::abs(towards.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 forward = length > 1e-9 ? way / length : glm::normalize(glm::cross(any, towards));
    const glm::dvec3 aside = glm::cross(towards, forward);
    const double radius = std::max(view.radius, 0.5 * distance * view.pixel);
    const double half = 0.5 * length + radius;
    // Its own light, spread over the place that is drawn.
    const double share = view.radius * view.radius / (radius * half);
    const double shown = std::clamp(share, LeastOpacity, MostOpacity);
    vtkIdType ids[4];
    for (int c = 0; c < 4; ++c)
    {
      const double s = c == 0 || c == 3 ? -1.0 : 1.0;
      const double t = c < 2 ? -1.0 : 1.0;
      const glm::dvec3 corner = place + s * half * forward + t * radius * aside;
      ids[c] = points->InsertNextPoint(corner.x, corner.y, corner.z);
      normals->InsertNextTuple3(towards.x, towards.y, towards.z);
      opacity->InsertNextValue(static_cast<float>(shown));
      along->InsertNextValue(static_cast<float>(s));
      across->InsertNextValue(static_cast<float>(t));
    }
    cells->InsertNextCell(4, ids);
  }
  auto streaks = vtkSmartPointer<vtkPolyData>::New();
  streaks->SetPoints(points);
  streaks->SetPolys(cells);
  streaks->GetPointData()->SetNormals(normals);
  for (const auto& array : { opacity, across, along })
  {
    streaks->GetPointData()->AddArray(array);
  }
  return streaks;
}

}
