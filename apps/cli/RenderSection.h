#pragma once

#include "Console.h"
#include "Request.h"

#include <string>

namespace swellray::cli
{

/** `render --style section`: the sea cut along a line, a panel a profile or a time. @throws WorkError, UsageError */
void renderSection(const Request& request, const std::string& title, Console& console);

}
