#include "Case.h"

#include "Families.h"

#include <cmath>
#include <limits>

namespace swellray::validation
{

std::vector<Case> allCases()
{
  std::vector<Case> cases;
  for (const auto& family :
    { dispersionCases, straightCases, designCases, shallowCases, circularCases, ellipticCases, breakingCases,
      currentCases, reflectionCases, ellipsoidCases, gridCases, schemeCases, waveFieldCases, mildSlopeCases })
  {
    for (Case& one : family())
    {
      cases.push_back(std::move(one));
    }
  }
  return cases;
}

double fittedOrder(const std::vector<double>& sizes, const std::vector<double>& errors)
{
  double n = 0.0;
  double sx = 0.0;
  double sy = 0.0;
  double sxx = 0.0;
  double sxy = 0.0;
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    if (!(errors[i] > 0.0) || !std::isfinite(errors[i]))
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    const double x = std::log(sizes[i]);
    const double y = std::log(errors[i]);
    n += 1.0;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

Series fittedLine(const Series& dots, double order)
{
  double middle = 0.0;
  for (std::size_t i = 0; i < dots.x.size(); ++i)
  {
    middle += (std::log(dots.y[i]) - order * std::log(dots.x[i])) / static_cast<double>(dots.x.size());
  }
  Series line{ "fitted", Series::Look::Dashes, {}, {} };
  for (const double x : { dots.x.front(), dots.x.back() })
  {
    line.add(x, std::exp(middle + order * std::log(x)));
  }
  return line;
}

}
