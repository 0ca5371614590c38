#include "Console.h"

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
    fmt::format("\r{:<10} [{}{}] {:3.0f} %", task, std::string(static_cast<std::size_t>(full), '#'),
      std::string(static_cast<std::size_t>(Width - full), ' '), 100.0 * known);
  if (bar != this->Shown)
  {
    std::fputs(bar.c_str(), stderr);
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
