#ifndef AlgorithmExecution_h
#define AlgorithmExecution_h

#include "sim/Execution.h"
#include "swellrayFiltersModule.h"

class vtkAlgorithm;

namespace swellray
{

/**
 * Run the core for a VTK algorithm: its loops with vtkSMPTools, its progress as UpdateProgress from `from` to
 * `to`, and cancelling by AbortExecute. What a loop body throws is thrown again on the calling thread.
 */
Execution makeExecution(vtkAlgorithm* algorithm, double from = 0.0, double to = 1.0);

/** Loop over [0, n) with vtkSMPTools, or on this thread alone under OneThread: body(begin, end) on disjoint ranges. */
void parallelFor(std::size_t n, const std::function<void(std::size_t, std::size_t)>& body);

/**
 * While this is there the loops of filters that are updated by this thread stay on it: for callers that update several at a
 * time on threads of their own, as vtkSMPTools of VTK 9.1 are not to be called by several.
 */
class SWELLRAYFILTERS_EXPORT OneThread
{
public:
  OneThread();
  ~OneThread();
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;
};

}

#endif
