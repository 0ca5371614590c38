#pragma once

#include "Case.h"

namespace swellray::validation
{

/** Plots in rows of up to three as one SVG picture, made of text alone: no display, no fonts are needed. */
std::string drawSvg(const std::vector<Plot>& plots);

/** Text with the characters that XML keeps for itself replaced. */
std::string escapeXml(const std::string& text);

}
