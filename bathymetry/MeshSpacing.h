#pragma once

#include "bathymetry/Soundings.h"

namespace swellray
{

/**
 * Distance of neighbours in the finer part of a mesh, file coordinates: a tenth of the sides of its cells are shorter.
 * @param degrees true where x and y are longitude and latitude: sides as long as they are in degrees of latitude
 * @return 0 where no side has a length
 */
double fineSpacing(const Soundings& mesh, bool degrees);

}
