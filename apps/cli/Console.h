#pragma once

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

  /** Show the share done of a task, 0 to 1; nothing where stderr is no terminal or with --quiet. */
  void progress(const std::string& task, double share);

  /** Wipe the progress bar. */
  void endProgress();

private:
  void wipe();

  bool Quiet;
  bool Bar;
  std::string Shown;
  std::set<std::string> Warned;
  mutable std::mutex Mutex;
};

}
