#include "EllipticShoal.h"

#include <cmath>

namespace swellray::reference
{

Formula EllipticShoal::formula() const
{
  const EllipticShoal c = *this;
  const double angle = c.rotation * static_cast<double>(Pi) / 180.0;
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  const auto u = [=](const Jet& x, const Jet& y) { return cosine * x - sine * y; };
  const auto root = [=](const Jet& x, const Jet& y)
  {
    const Jet along = u(x, y);
    const Jet across = sine * x + cosine * y;
    return Jet(1.0) - along * along / (c.a * c.a) - across * across / (c.b * c.b);
  };
  Formula formula;
  // On the shoal, on the slope, on the shallow floor.
  formula.depth = [=](const Jet& x, const Jet& y, unsigned region)
  {
    Jet h(c.h0);
    if (region & 4u)
    {
      h = Jet(c.minDepth);
    }
    else if (region & 2u)
    {
      h = Jet(c.h0) - c.slope * (u(x, y) + Jet(c.toe));
    }
    return region & 1u ? h - c.height * sqrt(root(x, y)) + Jet(c.sunk) : h;
  };
  const double edge = c.sunk / c.height;
  formula.kinks.push_back([=](const Jet& x, const Jet& y) { return root(x, y) - Jet(edge * edge); });
  if (c.slope > 0.0)
  {
    formula.kinks.push_back([=](const Jet& x, const Jet& y) { return u(x, y) + Jet(c.toe); });
    formula.kinks.push_back(
      [=](const Jet& x, const Jet& y) { return u(x, y) - Jet((c.h0 - c.minDepth) / c.slope - c.toe); });
  }
  return formula;
}

}
