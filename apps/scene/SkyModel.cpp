#include "SkyModel.h"

#include "sim/Angles.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace swellray::scene
{

namespace
{

// Slope and offset over turbidity of A to E, for luminance, x and y: table 2 of the paper.
constexpr double Perez[5][3][2] = {
  { { 0.1787, -1.4630 }, { -0.0193, -0.2592 }, { -0.0167, -0.2608 } },
  { { -0.3554, 0.4275 }, { -0.0665, 0.0008 }, { -0.0950, 0.0092 } },
  { { -0.0227, 5.3251 }, { -0.0004, 0.2125 }, { -0.0079, 0.2102 } },
  { { 0.1206, -2.5771 }, { -0.0641, -0.8989 }, { -0.0441, -1.6537 } },
  { { -0.0670, 0.3703 }, { -0.0033, 0.0452 }, { -0.0109, 0.0529 } },
};

// Chromaticities of the zenith: rows T^2, T, 1; columns theta_s^3, theta_s^2, theta_s, 1.
constexpr double ZenithX[3][4] = { { 0.00166, -0.00375, 0.00209, 0.0 }, { -0.02903, 0.06377, -0.03202, 0.00394 },
  { 0.11693, -0.21196, 0.06052, 0.25886 } };
constexpr double ZenithY[3][4] = { { 0.00275, -0.00610, 0.00317, 0.0 }, { -0.04214, 0.08970, -0.04153, 0.00516 },
  { 0.15346, -0.26756, 0.06670, 0.26688 } };

// Near the horizon the distribution has no limit that a picture could use.
constexpr double LeastCosine = 0.03;

double chromaticity(const double table[3][4], double turbidity, double sunZenith)
{
  const double powers[4] = { sunZenith * sunZenith * sunZenith, sunZenith * sunZenith, sunZenith, 1.0 };
  const double rows[3] = { turbidity * turbidity, turbidity, 1.0 };
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      sum += rows[i] * table[i][j] * powers[j];
    }
  }
  return sum;
}

void check(const char* name, double value, double low, double high)
{
  if (!(value >= low && value <= high))
  {
    std::ostringstream message;
    message << name << " is " << value << "; it must be within " << low << " to " << high;
    throw std::invalid_argument(message.str());
  }
}

}

SkyModel::SkyModel(double azimuth, double elevation, double turbidity)
{
  check("the azimuth of the sun", azimuth, -360.0, 360.0);
  check("the elevation of the sun", elevation, 2.0, 90.0);
  check("turbidity", turbidity, 2.0, 10.0);
  const double east = std::sin(radians(azimuth));
  const double north = std::cos(radians(azimuth));
  const double level = std::cos(radians(elevation));
  this->Sun = { east * level, north * level, std::sin(radians(elevation)) };
  for (std::size_t i = 0; i < 5; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      this->Coefficients[i][j] = Perez[i][j][0] * turbidity + Perez[i][j][1];
    }
  }
  const double zenithAngle = radians(90.0 - elevation);
  const double chi = (4.0 / 9.0 - turbidity / 120.0) * (Pi - 2.0 * zenithAngle);
  const Yxy zenith{ (4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192,
    chromaticity(ZenithX, turbidity, zenithAngle), chromaticity(ZenithY, turbidity, zenithAngle) };
  const Yxy there = this->distribution(1.0, zenithAngle);
  for (std::size_t j = 0; j < 3; ++j)
  {
    this->Scale[j] = zenith[j] / there[j];
  }
}

Yxy SkyModel::distribution(double cosZenith, double sunAngle) const
{
  const double cosine = std::max(LeastCosine, cosZenith);
  const double cosSun = std::cos(sunAngle);
  Yxy result;
  for (std::size_t j = 0; j < 3; ++j)
  {
    const auto c = [&](std::size_t i) { return this->Coefficients[i][j]; };
    result[j] =
      (1.0 + c(0) * std::exp(c(1) / cosine)) * (1.0 + c(2) * std::exp(c(3) * sunAngle) + c(4) * cosSun * cosSun);
  }
  return result;
}

Light SkyModel::light(const std::array<double, 3>& direction) const
{
  const double cosSun = direction[0] * this->Sun[0] + direction[1] * this->Sun[1] + direction[2] * this->Sun[2];
  const Yxy at = this->distribution(direction[2], std::acos(std::clamp(cosSun, -1.0, 1.0)));
  const double luminance = at[0] * this->Scale[0];
  const double x = at[1] * this->Scale[1];
  const double y = at[2] * this->Scale[2];
  const double X = luminance * x / y;
  const double Z = luminance * (1.0 - x - y) / y;
  // IEC 61966-2-1: XYZ to linear sRGB.
  return { 3.2404542 * X - 1.5371385 * luminance - 0.4985314 * Z,
    -0.9692660 * X + 1.8760108 * luminance + 0.0415560 * Z, 0.0556434 * X - 0.2040259 * luminance + 1.0572252 * Z };
}

double SkyModel::middleLuminance() const
{
  // Level, to the right of the sun, and up by 30 degrees.
  const double level = std::hypot(this->Sun[0], this->Sun[1]);
  const double right[2] = { level > 0.0 ? this->Sun[1] / level : 1.0, level > 0.0 ? -this->Sun[0] / level : 0.0 };
  const double up = std::sin(radians(30.0));
  const double along = std::cos(radians(30.0));
  const Light light = this->light({ along * right[0], along * right[1], up });
  return 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
}

}
