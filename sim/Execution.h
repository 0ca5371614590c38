#pragma once

#include <cstddef>
#include <functional>

namespace swellray
{

/**
 * How the caller wants long work to be run. The core starts no threads: the caller hands in a loop.
 */
struct Execution
{
  /**
   * Called now and then from the caller's thread with the share done, 0 to 1; returning false cancels.
   * Empty: no progress, no cancelling.
   */
  std::function<bool(double)> progress;

  /**
   * loop(n, body) must call body(begin, end) on disjoint ranges that cover [0, n), on any threads, and
   * return when all are done. Empty: one range on the calling thread.
   */
  std::function<void(std::size_t, const std::function<void(std::size_t, std::size_t)>&)> loop;

  /** Run body over [0, n) with the loop, or here where there is none. */
  void forRange(std::size_t n, const std::function<void(std::size_t, std::size_t)>& body) const
  {
    if (loop)
    {
      loop(n, body);
    }
    else if (n > 0)
    {
      body(0, n);
    }
  }

  /** Report the share done; false when the caller wants to stop. */
  bool report(double share) const { return !progress || progress(share); }
};

}
