#pragma once

#include "WorkPlan.h"

namespace swellray::cli
{

class Console;

/** What a trace will take, found by tracing some of its rays. */
struct RayPlan
{
  double launched = 0.0; ///< rays
  Estimate rays;         ///< with those inserted
  Estimate steps;        ///< of the integrator
  Estimate points;
  double fronts = 0.0;
  Estimate bytes;       ///< of memory
  Estimate seconds;     ///< on the threads in use
  double sampled = 0.0; ///< rays that told it, those inserted among them: the output of the pipeline
};

void sayPlan(const RayPlan& plan, const Console& console);

}
