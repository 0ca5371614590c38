#ifndef AlgorithmExecution_h
#define AlgorithmExecution_h

#include "sim/Execution.h"

class vtkAlgorithm;

namespace swellray
{

/**
 * Run the core for a VTK algorithm: its loops with vtkSMPTools, its progress as UpdateProgress from `from` to
 * `to`, and cancelling by AbortExecute. What a loop body throws is thrown again on the calling thread.
 */
Execution makeExecution(vtkAlgorithm* algorithm, double from = 0.0, double to = 1.0);

/** Loop over [0, n) with vtkSMPTools: body(begin, end) on disjoint ranges. */
void parallelFor(std::size_t n, const std::function<void(std::size_t, std::size_t)>& body);

}

#endif
