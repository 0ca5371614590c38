#pragma once

#include "sim/RayField.h"

namespace swellray
{

/**
 * Find RayCaustic::alongRate and alongChange of all caustics of a field, from those of neighbouring rays.
 *
 * A caustic is the line of the places x(lambda) that the rays touch, t.x the way along it at the ray's own place, t being
 * the ray's unit vector there. Its derivatives by lambda are taken from the neighbours on either side at unequal
 * distances, the first of second order in their distance, the second of first (of second where they are equal); at the
 * end of a row from two on one side, or, first order and no change, from one. Neighbours are rays next to each other in
 * launch parameter, of one launch segment, that touch their caustic of the same number; lee rays are none.
 */
void findCausticRates(RayField& field);

}
