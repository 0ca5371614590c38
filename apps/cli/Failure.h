#pragma once

#include <stdexcept>

namespace swellray::cli
{

/** Exit codes of the program. */
enum ExitCode : int
{
  Done = 0,
  WorkFailed = 1,
  WrongCall = 2,
};

/** The call is wrong: exit code 2. One line, without the program's name. */
struct UsageError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/** The work failed: exit code 1. One line, without the program's name. */
struct WorkError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

}
