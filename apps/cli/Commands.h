#pragma once

#include "Options.h"

namespace swellray::cli
{

// One function a command, each in the file that also does its work; the options write into request, which must
// outlive them.

CommandSpec infoSpec(Request& request);
CommandSpec contourSpec(Request& request);
CommandSpec gridSpec(Request& request);
CommandSpec traceSpec(Request& request);
CommandSpec surfaceSpec(Request& request);
CommandSpec seaSpec(Request& request);
CommandSpec spectrumSpec(Request& request);
CommandSpec renderSpec(Request& request);
CommandSpec viewSpec(Request& request);
CommandSpec validateSpec(Request& request);
CommandSpec againSpec(Request& request);
CommandSpec listSpec();
CommandSpec completionSpec(Request& request);
CommandSpec manualSpec(Request& request);

}
