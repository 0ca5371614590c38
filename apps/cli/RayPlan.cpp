#include "RayPlan.h"

#include "FieldValues.h"
#include "FilterRun.h"
#include "Pipeline.h"

#include <fmt/format.h>

#include <vtkPolyData.h>

#include <algorithm>
#include <chrono>

namespace swellray::cli
{

namespace
{

// Launched rays that are traced to plan the others: twice as many again and again, at least twice, until these take that
// long. How the work grows with the rays is told by the last two, since rays in the lee find more of a coast the more they are.
constexpr double PilotRays = 50.0;
constexpr double PilotGrowth = 2.0;
constexpr double PilotSeconds = 0.5;

// Memory of a trace over that of the rays with their arrays: the fronts as they are recorded come beside.
constexpr double CopiesOfRays = 2.0;

struct Pilot
{
  double rays = 0.0;
  double steps = 0.0;
  double points = 0.0;
  double bytes = 0.0;
  double seconds = 0.0;
};

}

RayPlan Pipeline::planRays()
{
  this->takeLaunch();
  // One front tells what the trace chooses; its warnings are not those of the trace.
  const int insertion = this->Tracer->GetInsertion();
  const vtkIdType fronts = this->Tracer->GetMaximumNumberOfFronts();
  this->Tracer->SetInsertion(vtkSwellRayTracer::INSERT_NONE);
  this->Tracer->SetMaximumNumberOfFronts(1);
  this->Tracer->Update();
  vtkPolyData* chosen = this->Tracer->GetOutput();
  const auto value = [&](const char* name) { return fieldNumber(chosen, name).value_or(0.0); };
  const double spacing = value("LaunchSpacing");
  const double maxSpacing = value("MaxSpacing");
  const double width = value("LaunchWidth");
  const bool fromPoints = fieldNumber(chosen, "LaunchPoints").has_value();
  RayPlan plan;
  plan.launched = static_cast<double>(chosen->GetNumberOfCells());
  const bool canThin = spacing > 0.0 && !fromPoints;
  if (canThin && !this->Asked.rays.trace.step)
  {
    this->Tracer->SetStepsPerWave(value("StepsPerWave"));
  }
  this->Tracer->SetInsertion(insertion);
  this->Tracer->SetMaximumNumberOfFronts(fronts);

  Pilot before;
  Pilot pilot;
  double thinned = canThin ? std::max(1.0, width / spacing / PilotRays) : 1.0;
  double growth = PilotGrowth;
  double spent = 0.0;
  for (int i = 0;; ++i)
  {
    if (canThin)
    {
      this->Tracer->SetSpacing(thinned * spacing);
      this->Tracer->SetMaxSpacing(thinned * maxSpacing);
    }
    const auto begin = std::chrono::steady_clock::now();
    runFilter(this->Tracer, "planning", this->Screen);
    vtkPolyData* rays = this->computeHeights();
    constexpr double Kibibyte = 1024.0;
    pilot.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    pilot.rays = static_cast<double>(rays->GetNumberOfCells());
    pilot.steps = fieldNumber(rays, "RaySteps").value_or(0.0);
    pilot.points = static_cast<double>(rays->GetNumberOfPoints());
    pilot.bytes = CopiesOfRays * Kibibyte * static_cast<double>(rays->GetActualMemorySize());
    plan.fronts = fieldNumber(rays, "Fronts").value_or(0.0);
    spent += pilot.seconds;
    if (thinned <= 1.0 || (i > 0 && spent > PilotSeconds))
    {
      break;
    }
    before = pilot;
    growth = std::min(PilotGrowth, thinned);
    thinned /= growth;
  }
  const auto estimate = [&](double Pilot::*part) { return extrapolate(pilot.*part, before.*part, growth, thinned); };
  plan.rays = estimate(&Pilot::rays);
  plan.rays.limit(std::max(plan.launched, static_cast<double>(this->Tracer->GetMaximumNumberOfRays())));
  plan.steps = estimate(&Pilot::steps);
  plan.points = estimate(&Pilot::points);
  plan.bytes = estimate(&Pilot::bytes);
  plan.seconds = estimate(&Pilot::seconds);
  plan.sampled = pilot.rays;
  return plan;
}

void sayPlan(const RayPlan& plan, const Console& console)
{
  console.say(fmt::format("plan     {:.0f} rays launched, {} with those inserted, in {} steps; {} points on some {} "
                          "fronts",
    plan.launched, plan.rays.text(), plan.steps.text(), plan.points.text(), roughly(plan.fronts)));
  console.say(
    fmt::format("cost     {} of memory and {}, beside maps and files", memoryText(plan.bytes), timeText(plan.seconds)));
}

}
