#include "bathymetry/Georeference.h"

#include <cmath>
#include <cstdio>

// A minute of arc of latitude is a nautical mile, within the 1 % that the ellipsoid makes of it.
int main()
{
  const swellray::Georeference georeference(swellray::crsToWkt("EPSG:4326"), { -73.0, 40.0 }, { 0.0, 0.0 });
  const double metres = georeference.fromFile({ -73.0, 40.0 + 1.0 / 60.0 }).y;
  std::printf("a minute of latitude: %.1f m\n", metres);
  return std::abs(metres / 1852.0 - 1.0) < 0.01 ? 0 : 1;
}
