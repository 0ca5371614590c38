#pragma once

#include "Options.h"

namespace swellray::cli
{

/** Vertical section of the waves; --profile. */
OptionSpec profileOption(SurfaceRequest& surface);

/** Of what waves the sea is, and how long its foam lasts: shared by all that draw or write its surface. */
std::vector<OptionSpec> surfaceOptions(SurfaceRequest& surface);

/** @throws UsageError where options of the surface do not go together */
void checkSurfaceOptions(const SurfaceRequest& surface);

}
