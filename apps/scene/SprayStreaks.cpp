#include "SprayStreaks.h"

#include "sim/Scramble.h"

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
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace swellray::scene
{

namespace
{

// Each particle stands for some, which are seen where one would not be.
constexpr double LeastOpacity = 0.4;
constexpr double MostOpacity = 0.95;

// What is fainter is lost in a picture of 8 bits: instead, fewer are drawn.
constexpr double FaintestOpacity = 0.06;

// One particle in so many is a wisp; it spreads by its own radius in the time in which it falls by a few of them.
constexpr std::uint32_t WispEvery = 2;
constexpr double WispOpacity = 0.5;
constexpr double SpreadFalls = 6.0;
constexpr double Gravity = 9.81; // m/s2

// Light that is lost at this speed downwards, over that of droplets that rise (Peachey 1986, section 4.3).
constexpr double ShadeLost = 0.3;
constexpr double ShadeSpeed = 4.0; // m/s

// A number that stays with a particle: its horizontal velocity does.
std::uint32_t markOf(const glm::dvec3& velocity)
{
  const std::array<float, 2> kept{ static_cast<float>(velocity.x), static_cast<float>(velocity.y) };
  std::uint64_t bits = 0;
  std::memcpy(&bits, kept.data(), sizeof bits);
  return static_cast<std::uint32_t>(scramble(bits) >> 32U);
}

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
  const auto shade = arrayOf("Shade", 1);
  vtkDataArray* ages = spray->GetPointData()->GetArray("Age");
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
    const std::uint32_t mark = markOf(velocity);
    const bool isWisp = view.wisp > 0.0 && mark % WispEvery == 0;
    const double age = isWisp && ages ? ages->GetTuple1(i) : 0.0;
    const double spread = isWisp ? 1.0 + age / std::sqrt(2.0 * SpreadFalls * view.wisp / Gravity) : 1.0;
    const double own = isWisp ? view.wisp * (0.6 + 0.8 * unitOf(scramble(mark))) * spread : view.radius;
    const double radius = std::max(own, 0.5 * distance * view.pixel);
    const double half = 0.5 * length + radius;
    // Its own light, spread over the place that is drawn.
    const double share = own * own / (radius * half);
    double shown = isWisp ? WispOpacity * share / (spread * spread) : std::clamp(share, LeastOpacity, MostOpacity);
    if (shown < FaintestOpacity)
    {
      if (unitOf(scramble(mark + 1u)) * FaintestOpacity >= shown)
      {
        continue;
      }
      shown = FaintestOpacity;
    }
    const double lit = 1.0 - ShadeLost * std::clamp(-velocity.z / ShadeSpeed, 0.0, 1.0);
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
      shade->InsertNextValue(static_cast<float>(lit));
      across->InsertNextValue(static_cast<float>(t));
    }
    cells->InsertNextCell(4, ids);
  }
  auto streaks = vtkSmartPointer<vtkPolyData>::New();
  streaks->SetPoints(points);
  streaks->SetPolys(cells);
  streaks->GetPointData()->SetNormals(normals);
  for (const auto& array : { opacity, across, along, shade })
  {
    streaks->GetPointData()->AddArray(array);
  }
  return streaks;
}

}
