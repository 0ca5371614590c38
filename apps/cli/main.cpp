#include "CommandLine.h"
#include "Failure.h"
#include "FilterRun.h"
#include "OutputFile.h"
#include "Sweep.h"

#include "bathymetry/Text.h"

#include <vtkSMPTools.h>

#include <cstdio>
#include <exception>
#include <new>

namespace
{

using namespace swellray::cli;

void run(const Call& call)
{
  const Request& request = call.request;
  if (request.threads > 0)
  {
    vtkSMPTools::Initialize(request.threads);
  }
  Console console(request.quiet);
  if (call.cases.empty())
  {
    call.run(call.request, console);
    return;
  }
  runSweep(call.request, call.cases, call.run, console);
}

int report(const char* message, int code)
{
  std::fprintf(stderr, "swellray: %s\n", swellray::oneLine(message).c_str());
  return code;
}

}

int main(int argc, char** argv)
{
  try
  {
    installSignalHandlers();
    silenceVtk();
    const auto call = readCommandLine({ argv, argv + argc });
    if (call)
    {
      run(*call);
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
    {
      return report("cannot write to the standard output", WorkFailed);
    }
    return Done;
  }
  catch (const UsageError& error)
  {
    return report(error.what(), WrongCall);
  }
  catch (const std::bad_alloc&)
  {
    return report(
      "out of memory: take a part of the seafloor with --crop, or a coarser one with --resample", WorkFailed);
  }
  catch (const std::exception& error)
  {
    return report(error.what(), WorkFailed);
  }
}
