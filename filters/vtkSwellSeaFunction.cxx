#include "vtkSwellSeaFunction.h"

#include "sim/SeaSurface.h"

#include <vtkObjectFactory.h>

#include <glm/geometric.hpp>

#include <utility>

vtkStandardNewMacro(vtkSwellSeaFunction);

vtkSwellSeaFunction::vtkSwellSeaFunction() = default;
vtkSwellSeaFunction::~vtkSwellSeaFunction() = default;

void vtkSwellSeaFunction::SetSurface(std::shared_ptr<const swellray::SeaSurface> surface)
{
  if (surface != this->Surface)
  {
    this->Surface = std::move(surface);
    this->Modified();
  }
}

double vtkSwellSeaFunction::EvaluateFunction(double x[3])
{
  return this->Surface ? x[2] - this->Surface->height({ x[0], x[1] }, this->Time, this->Footprint) : x[2];
}

void vtkSwellSeaFunction::EvaluateGradient(double x[3], double gradient[3])
{
  gradient[0] = 0.0;
  gradient[1] = 0.0;
  gradient[2] = 1.0;
  if (this->Surface)
  {
    const glm::dvec3 normal = this->Surface->normal({ x[0], x[1] }, this->Time, this->Footprint);
    gradient[0] = normal.x / normal.z;
    gradient[1] = normal.y / normal.z;
  }
}

double vtkSwellSeaFunction::March(const double origin[3], const double direction[3], double farthest, double pixel)
{
  const glm::dvec3 along(direction[0], direction[1], direction[2]);
  if (!this->Surface || !(glm::length(along) > 0.0))
  {
    return -1.0;
  }
  const glm::dvec3 from(origin[0], origin[1], origin[2]);
  return this->Surface->march(from, glm::normalize(along), this->Time, farthest, pixel).value_or(-1.0);
}

void vtkSwellSeaFunction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surface: " << (this->Surface ? "set" : "(none)") << "\n";
  os << indent << "Time: " << this->Time << "\n";
  os << indent << "Footprint: " << this->Footprint << "\n";
}
