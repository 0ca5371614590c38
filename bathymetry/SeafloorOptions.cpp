#include "bathymetry/SeafloorOptions.h"

#include "bathymetry/Text.h"

#include <cmath>
#include <stdexcept>

namespace swellray
{

void SeafloorOptions::validate() const
{
  if (this->resample && !(*this->resample > 0.0 && std::isfinite(*this->resample)))
  {
    throw std::invalid_argument("resample must be above 0 m, not " + text(*this->resample));
  }
  if (!(this->smooth >= 0.0 && std::isfinite(this->smooth)))
  {
    throw std::invalid_argument("smooth must be 0 m or more, not " + text(this->smooth));
  }
  if (this->maxGap && !(*this->maxGap >= 0.0))
  {
    throw std::invalid_argument("max-gap must be 0 m or more, not " + text(*this->maxGap));
  }
  if (!std::isfinite(this->waterLevel))
  {
    throw std::invalid_argument("water-level must be a number of metres, not " + text(this->waterLevel));
  }
  if (this->earth == EarthModel::Ellipsoid && this->smooth > 0.0)
  {
    throw std::invalid_argument(
      "on the ellipsoid the grid is taken as it is, in longitude and latitude: leave out smooth");
  }
  if (this->crop)
  {
    const auto& c = *this->crop;
    if (!(c[0] < c[2] && c[1] < c[3]) || !std::isfinite(c[2] - c[0]) || !std::isfinite(c[3] - c[1]))
    {
      throw std::invalid_argument("crop must be x0,y0,x1,y1 with x0 < x1 and y0 < y1, not " + text(c[0]) + "," +
        text(c[1]) + "," + text(c[2]) + "," + text(c[3]));
    }
  }
}

}
