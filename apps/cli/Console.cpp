#include "Console.h"

#include "WorkPlan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <unistd.h>

namespace swellray::cli
{

Console::Console(bool quiet)
  : Quiet(quiet)
  , Bar(!quiet && isatty(STDERR_FILENO) == 1)
{
}

void Console::say(const std::string& line) const
{
  if (!this->Quiet)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
  }
}

void Console::warn(const std::string& line)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (!this->Warned.insert(line).second)
  {
    return;
  }
  this->wipe();
  std::fprintf(stderr, "swellray: warning: %s\n", line.c_str());
}

// As fast as so far; what was done before it began, as frames that are kept, took no time.
std::string Console::timeLeft(const std::string& task, double share)
{
  const Clock::time_point now = Clock::now();
  if (task != this->Task || share < this->LastShare)
  {
    this->Task = task;
    this->FirstShare = share;
    this->Begin = now;
  }
  this->LastShare = share;
  constexpr double Moment = 1.0;      // s
  constexpr double LeastShare = 0.02; // that tells how long the rest takes
  const double seconds = std::chrono::duration<double>(now - this->Begin).count();
  const double done = share - this->FirstShare;
  if (seconds < Moment || done < LeastShare || share >= 1.0)
  {
    return {};
  }
  return fmt::format(", {} left", timeText({ seconds * (1.0 - share) / done, seconds * (1.0 - share) / done }));
}

void Console::progress(const std::string& task, double share)
{
  if (!this->Bar)
  {
    return;
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  constexpr int Width = 40;
  const double known = std::clamp(share, 0.0, 1.0);
  const int full = static_cast<int>(std::lround(known * Width));
  const std::string bar =
    fmt::format("\r{:<10} [{}{}] {:3.0f} %{}", task, std::string(static_cast<std::size_t>(full), '#'),
      std::string(static_cast<std::size_t>(Width - full), ' '), 100.0 * known, this->timeLeft(task, known));
  if (bar != this->Shown)
  {
    // Spaces over what a longer one has left behind.
    const std::size_t longer = this->Shown.size() > bar.size() ? this->Shown.size() - bar.size() : 0;
    std::fputs((bar + std::string(longer, ' ')).c_str(), stderr);
    std::fflush(stderr);
    this->Shown = bar;
  }
}

void Console::endProgress()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->wipe();
}

void Console::wipe()
{
  if (!this->Shown.empty())
  {
    std::fprintf(stderr, "\r%*s\r", static_cast<int>(this->Shown.size()), "");
    this->Shown.clear();
  }
}

}
