#include "AlgorithmExecution.h"

#include <vtkAlgorithm.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <exception>
#include <mutex>

namespace swellray
{

namespace
{

// Enough ranges to balance uneven rays over any usual number of cores, few enough to cost nothing.
constexpr std::size_t RangesOfALoop = 64;

thread_local int oneThread = 0; // how many of it are there

}

OneThread::OneThread()
{
  ++oneThread;
}

OneThread::~OneThread()
{
  --oneThread;
}

void parallelFor(std::size_t n, const std::function<void(std::size_t, std::size_t)>& body)
{
  if (n == 0)
  {
    return;
  }
  if (oneThread > 0)
  {
    body(0, n);
    return;
  }
  std::mutex mutex;
  std::exception_ptr failure;
  std::size_t failedAt = n;
  const std::size_t grain = std::max<std::size_t>(1, n / RangesOfALoop);
  // An exception must not leave a worker thread, and the one that is reported must not depend on their timing.
  vtkSMPTools::For(0, static_cast<vtkIdType>(n), static_cast<vtkIdType>(grain),
    [&](vtkIdType begin, vtkIdType end)
    {
      try
      {
        body(static_cast<std::size_t>(begin), static_cast<std::size_t>(end));
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        if (static_cast<std::size_t>(begin) < failedAt)
        {
          failedAt = static_cast<std::size_t>(begin);
          failure = std::current_exception();
        }
      }
    });
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}

Execution makeExecution(vtkAlgorithm* algorithm, double from, double to)
{
  Execution execution;
  execution.loop = parallelFor;
  execution.progress = [=](double share)
  {
    algorithm->UpdateProgress(from + (to - from) * share);
    return !algorithm->GetAbortExecute();
  };
  return execution;
}

}
