#pragma once

#include <string>

namespace swellray::cli
{

/** The version and the build: libraries and compiler, several lines. */
std::string versionText();

}
