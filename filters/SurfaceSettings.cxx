#include "SurfaceSettings.h"

#include <vtkInformation.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace swellray
{

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

// More would be a mistake in the step.
constexpr double MostTimeSteps = 1e6;

constexpr double FewestPointsPerWave = 16.0;

}

std::string sectionSpec(const std::string& name, const std::string& parameters)
{
  return parameters.empty() ? name : name + (name.find(':') == std::string::npos ? ":" : ",") + parameters;
}

void requirePositive(const char* name, double value)
{
  if (!(value > 0.0) || std::isinf(value))
  {
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) + "; it must be above 0 and finite");
  }
}

void setTimeSteps(vtkInformation* output, const double range[2], double step)
{
  requirePositive("TimeStep", step);
  const double length = range[1] - range[0];
  if (!(length >= 0.0) || std::isinf(length))
  {
    throw std::invalid_argument("TimeRange ends before it begins");
  }
  // A range that is whole steps but for rounding keeps its last.
  constexpr double rounding = 1e-9;
  const double steps = std::floor(length / step + rounding) + 1.0;
  if (steps > MostTimeSteps)
  {
    throw std::invalid_argument("TimeRange has more than a million steps; choose a larger TimeStep");
  }
  std::vector<double> times(static_cast<std::size_t>(steps));
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    times[i] = range[0] + static_cast<double>(i) * step;
  }
  output->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
  const std::array<double, 2> ends{ times.front(), times.back() };
  output->Set(Pipeline::TIME_RANGE(), ends.data(), 2);
}

double requestedTime(vtkInformation* output, double otherwise)
{
  const double time = output->Has(Pipeline::UPDATE_TIME_STEP()) ? output->Get(Pipeline::UPDATE_TIME_STEP()) : otherwise;
  if (!std::isfinite(time))
  {
    throw std::invalid_argument("Time is not finite");
  }
  return time;
}

void askAtNoTime(vtkInformation* input)
{
  input->Remove(Pipeline::UPDATE_TIME_STEP());
}

double pointsPerWave(double setting, double ofSection)
{
  if (setting != 0.0 && !(setting >= FewestPointsPerWave))
  {
    throw std::invalid_argument("PointsPerWave is " + std::to_string(setting) +
      "; it must be 16 or more, or 0 for as many as the section asks for");
  }
  return setting > 0.0 ? setting : ofSection;
}

}
