#include "VirtualDisplay.h"

#include <stdexcept>

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

namespace swellray::drawing
{

namespace
{

constexpr int Attempts = 3;
constexpr int FirstDisplay = 100;
constexpr int Displays = 50'000;
constexpr int Stride = 7'919;
constexpr int StartTimeout = 20'000; // ms; a loaded machine takes seconds

[[noreturn]] void failWithoutDisplay()
{
  throw std::runtime_error(
    "no display to draw on: set DISPLAY, or install Xvfb (package xvfb), or run under 'xvfb-run -a'");
}

// VTK has loaded libX11.
template <typename Function>
Function x11(const char* name)
{
  return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
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

void stopServer(pid_t server)
{
  if (server > 0)
  {
    kill(server, SIGTERM);
    waitpid(server, nullptr, 0);
  }
}

// Start a server; 0 where it does not come up, otherwise its process with DISPLAY set.
pid_t startServer(int attempt)
{
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
  {
    return 0;
  }
  const std::string descriptor = std::to_string(ends[1]);
  const pid_t parent = getpid();
  // Servers that look for a free number by themselves at the same moment can end up sharing one; no two processes
  // share a process id.
  const std::string display = ":" + std::to_string(FirstDisplay + (parent + attempt * Stride) % Displays);
  const pid_t server = fork();
  if (server == 0)
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
    // Without -noreset the server starts afresh whenever its last client leaves, and refuses the next one meanwhile.
    execlp("Xvfb", "Xvfb", display.c_str(), "-displayfd", descriptor.c_str(), "-screen", "0", "1280x1024x24",
      "-nolisten", "tcp", "-noreset", static_cast<char*>(nullptr));
    _exit(127);
  }
  close(ends[1]);
  const std::string number = server > 0 ? readDisplayNumber(ends[0]) : std::string();
  close(ends[0]);
  if (!number.empty())
  {
    setenv("DISPLAY", (":" + number).c_str(), 1);
    return server;
  }
  stopServer(server);
  return 0;
}

}

VirtualDisplay::VirtualDisplay()
{
  if (this->connect())
  {
    return;
  }
  // The number may be taken all the same, by a server of another user or container: try others.
  for (int attempt = 0; attempt < Attempts; ++attempt)
  {
    this->Server = startServer(attempt);
    if (this->Server > 0 && this->connect())
    {
      return;
    }
    this->stop();
  }
  failWithoutDisplay();
}

VirtualDisplay::~VirtualDisplay()
{
  this->stop();
}

bool VirtualDisplay::answers()
{
  const char* name = std::getenv("DISPLAY");
  const auto open = x11<void* (*)(const char*)>("XOpenDisplay");
  if (!name || !*name || !open)
  {
    return false;
  }
  void* connection = open(nullptr);
  if (connection)
  {
    x11<int (*)(void*)>("XCloseDisplay")(connection);
  }
  return connection != nullptr;
}

// VTK ends the process where the display that is set does not answer, so ask before. The connection is kept: a server
// whose last client leaves may start afresh and refuse the next one.
bool VirtualDisplay::connect()
{
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name)
  {
    return false;
  }
  const auto open = x11<void* (*)(const char*)>("XOpenDisplay");
  if (!open)
  {
    return true;
  }
  this->Connection = open(nullptr);
  return this->Connection != nullptr;
}

void VirtualDisplay::stop()
{
  if (this->Connection)
  {
    x11<int (*)(void*)>("XCloseDisplay")(this->Connection);
    this->Connection = nullptr;
  }
  if (this->Server > 0)
  {
    stopServer(this->Server);
    this->Server = 0;
    unsetenv("DISPLAY");
  }
}

}
