#include "sim/forms/CurvedCoast.h"

#include <algorithm>
#include <limits>

namespace swellray
{

CurvedCoast::CurvedCoast(const Rectangle& bounds, double bearing, const Shape& shape)
  : Bounds(bounds)
  , Frame(LocalFrame::facing(bearing))
  , Coast(shape)
{
}

double CurvedCoast::coveShare()
{
  return 2.0 * std::exp(-1.5);
}

double CurvedCoast::featureLength() const
{
  return 0.5 * std::min(this->Coast.sigma, this->Coast.fade);
}

void CurvedCoast::evaluate(const glm::dvec2& p, unsigned, BedSample& bed) const
{
  const glm::dvec2 local = this->Frame.toLocal(p);
  const double t = local.y / this->Coast.sigma;
  const double bell = this->Coast.reach * std::exp(-0.5 * t * t);
  const double shore = (1.0 - t * t) * bell;
  const double shore1 = t * (t * t - 3.0) * bell / this->Coast.sigma;
  const double shore2 = ((6.0 - t * t) * t * t - 3.0) * bell / (this->Coast.sigma * this->Coast.sigma);

  // Depth over slope as f(d, us) = d + us T(d/e), and its derivatives.
  const double d = local.x - shore;
  const double fade = this->Coast.fade;
  const double tanh0 = std::tanh(d / fade);
  const double tanh1 = (1.0 - tanh0 * tanh0) / fade;
  const double tanh2 = -2.0 * tanh0 * tanh1 / fade;
  const double fd = 1.0 + shore * tanh1;
  const double fdd = shore * tanh2;
  const double fs = tanh0;
  const double fds = tanh1;

  const double s = -this->Coast.slope;
  bed.elevation = s * (d + shore * tanh0);
  bed.gradient = s * glm::dvec2(fd, (fs - fd) * shore1);
  bed.xx = s * fdd;
  bed.xy = s * (fds - fdd) * shore1;
  bed.yy = s * ((fs - fd) * shore2 + (fdd - 2.0 * fds) * shore1 * shore1);
  this->Frame.toScene(bed);
}

CurvedCoast::Interval CurvedCoast::shoreline(const Interval& v) const
{
  const double sigma = this->Coast.sigma;
  // Extremes at the ends of the interval and where the derivative vanishes.
  const double stationary[] = { v.low, v.high, 0.0, -std::sqrt(3.0) * sigma, std::sqrt(3.0) * sigma };
  Interval range{ std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
  for (const double at : stationary)
  {
    if (at >= v.low && at <= v.high)
    {
      const double t = at / sigma;
      const double shore = this->Coast.reach * (1.0 - t * t) * std::exp(-0.5 * t * t);
      range.low = std::min(range.low, shore);
      range.high = std::max(range.high, shore);
    }
  }
  return range;
}

CurvedCoast::Interval CurvedCoast::depthsIn(const Rectangle& box) const
{
  const Rectangle local = this->Frame.boxToLocal(box);
  const Interval shore = shoreline({ local.low.y, local.high.y });
  // h/s = u - us (1 - tanh(d/e)), the bracket between 0 and 2.
  const double least = 1.0 - std::tanh((local.high.x - shore.low) / this->Coast.fade);
  const double most = 1.0 - std::tanh((local.low.x - shore.high) / this->Coast.fade);
  const double highest = std::max(shore.high * least, shore.high * most);
  const double lowest = std::min(shore.low * least, shore.low * most);
  return { this->Coast.slope * (local.low.x - highest), this->Coast.slope * (local.high.x - lowest) };
}

double CurvedCoast::highestElevation(const Rectangle& box) const
{
  return -depthsIn(box).low;
}

double CurvedCoast::lowestElevation(const Rectangle& box) const
{
  return -depthsIn(box).high;
}

}
