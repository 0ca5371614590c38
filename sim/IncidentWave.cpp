#include "sim/IncidentWave.h"

#include "sim/Angles.h"
#include "sim/Dispersion.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace swellray
{

namespace
{

void require(bool holds, const char* rule, double value)
{
  if (!holds)
  {
    std::ostringstream message;
    message << rule << ", not " << value;
    throw std::invalid_argument(message.str());
  }
}

}

double IncidentWave::angularFrequency() const
{
  return 2.0 * Pi / this->period;
}

glm::dvec2 IncidentWave::direction() const
{
  const double theta = headingFromNautical(this->directionFrom);
  return { std::cos(theta), std::sin(theta) };
}

double IncidentWave::wavenumber() const
{
  return solveWavenumber(angularFrequency(), this->offshoreDepth, this->gravity);
}

double IncidentWave::groupSpeed() const
{
  return waveSpeeds(wavenumber(), this->offshoreDepth, this->gravity).groupSpeed;
}

void IncidentWave::validate() const
{
  require(this->period > 0.0 && std::isfinite(this->period), "period must be above 0 s", this->period);
  require(std::fabs(this->directionFrom) <= 360.0, "direction must be within -360 to 360 degrees", this->directionFrom);
  require(this->height > 0.0 && std::isfinite(this->height), "height must be above 0 m", this->height);
  require(this->offshoreDepth > 0.0, "offshore depth must be above 0 m (or deep)", this->offshoreDepth);
  require(this->gravity > 0.0 && std::isfinite(this->gravity), "gravity must be above 0 m/s2", this->gravity);
}

}
