#pragma once

#include "Console.h"
#include "Request.h"

namespace swellray::cli
{

void runInfo(const Request& request, Console& console);
void runContour(const Request& request, Console& console);
void runTrace(const Request& request, Console& console);
void runList();
void runRender(const Request& request, Console& console);
void runValidate(const Request& request, Console& console);

}
