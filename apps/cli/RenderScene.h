#pragma once

#include "Pipeline.h"

namespace swellray::cli
{

/**
 * Draw the water of the waves that the request gives, in three dimensions: a picture, or a movie of its times.
 * @param file is committed
 * @throws WorkError
 */
void renderScene(const Request& request, Console& console, OutputFile& file);

}
