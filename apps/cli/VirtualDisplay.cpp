#include "VirtualDisplay.h"

#include "Failure.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <string>

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace swellray::cli
{

namespace
{

constexpr int StartTimeout = 20'000; // ms; a loaded machine takes seconds

[[noreturn]] void failWithoutDisplay()
{
  throw WorkError("no display to draw on: set DISPLAY, or install Xvfb (package xvfb), or run under 'xvfb-run -a'");
}

// VTK ends the process where the display that is set does not answer, so ask before. It has loaded libX11.
bool displayAnswers()
{
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name)
  {
    return false;
  }
  using Open = void* (*)(const char*);
  using Close = int (*)(void*);
  const auto open = reinterpret_cast<Open>(dlsym(RTLD_DEFAULT, "XOpenDisplay"));
  const auto close = reinterpret_cast<Close>(dlsym(RTLD_DEFAULT, "XCloseDisplay"));
  if (!open || !close)
  {
    return true;
  }
  void* display = open(nullptr);
  if (display)
  {
    close(display);
  }
  return display != nullptr;
}

// The number of the display as the server writes it once it is up; empty where it does not come up.
std::string readDisplayNumber(int pipe)
{
  std::string number;
  pollfd wait{ pipe, POLLIN, 0 };
  while (poll(&wait, 1, StartTimeout) > 0)
  {
    char c = 0;
    if (read(pipe, &c, 1) != 1)
    {
      return {};
    }
    if (c == '\n')
    {
      return number;
    }
    number += c;
  }
  return {};
}

}

VirtualDisplay::VirtualDisplay()
{
  if (displayAnswers())
  {
    return;
  }
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
  {
    failWithoutDisplay();
  }
  const std::string descriptor = std::to_string(ends[1]);
  const pid_t parent = getpid();
  this->Server = fork();
  if (this->Server == 0)
  {
    // The server must not outlive the program, however that ends.
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent)
    {
      _exit(127);
    }
    fcntl(ends[1], F_SETFD, 0);
    const int nothing = open("/dev/null", O_RDWR);
    dup2(nothing, STDIN_FILENO);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
    execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", "1280x1024x24", "-nolisten", "tcp",
      static_cast<char*>(nullptr));
    _exit(127);
  }
  close(ends[1]);
  const std::string number = this->Server > 0 ? readDisplayNumber(ends[0]) : std::string();
  close(ends[0]);
  if (number.empty())
  {
    if (this->Server > 0)
    {
      kill(this->Server, SIGTERM);
      waitpid(this->Server, nullptr, 0);
    }
    failWithoutDisplay();
  }
  setenv("DISPLAY", (":" + number).c_str(), 1);
}

VirtualDisplay::~VirtualDisplay()
{
  if (this->Server > 0)
  {
    kill(this->Server, SIGTERM);
    waitpid(this->Server, nullptr, 0);
    unsetenv("DISPLAY");
  }
}

}
