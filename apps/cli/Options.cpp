#include "Options.h"

#include "Commands.h"

namespace swellray::cli
{

std::vector<CommandSpec> commandSpecs(Request& request)
{
  return {
    infoSpec(request),
    contourSpec(request),
    gridSpec(request),
    traceSpec(request),
    surfaceSpec(request),
    seaSpec(request),
    spectrumSpec(request),
    renderSpec(request),
    viewSpec(request),
    validateSpec(request),
    againSpec(request),
    listSpec(),
    completionSpec(request),
    manualSpec(request),
  };
}

}
