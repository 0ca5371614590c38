#pragma once

#include <chrono>
#include <mutex>
#include <set>
#include <string>

namespace swellray::cli
{

/** What the program says: results on stdout, warnings and progress on stderr; from any thread. */
class Console
{
public:
  explicit Console(bool quiet);

  /** A line of the summary; nothing with --quiet. */
  void say(const std::string& line) const;

  /** A line that is said even with --quiet, once: the result is there, but there is something to know about it. */
  void warn(const std::string& line);

  /**
   * Show the share done of a task, 0 to 1, and of one that takes longer than a moment the time that is left; nothing where
   * stderr is no terminal or with --quiet.
   */
  void progress(const std::string& task, double share);

  /** Wipe the progress bar. */
  void endProgress();

private:
  using Clock = std::chrono::steady_clock;

  void wipe();
  std::string timeLeft(const std::string& task, double share);

  bool Quiet;
  bool Bar;
  std::string Shown;
  std::string Task;        // that is shown
  double FirstShare = 0.0; // when it began to be
  double LastShare = 0.0;
  Clock::time_point Begin;
  std::set<std::string> Warned;
  mutable std::mutex Mutex;
};

}
