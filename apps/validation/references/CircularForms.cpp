#include "CircularForms.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace swellray::reference
{

namespace
{

std::string specOf(const char* form, std::initializer_list<std::pair<const char*, double>> keys)
{
  std::ostringstream text;
  text.precision(17);
  text << form;
  for (const auto& [key, value] : keys)
  {
    text << ',' << key << '=' << value;
  }
  return text.str();
}

}

Formula CircularForm::formula() const
{
  Formula result;
  result.depth = [of = this->ofSquare](const Jet& x, const Jet& y, unsigned region)
  { return of(x * x + y * y, region); };
  if (this->rim > 0.0)
  {
    result.kinks.push_back([rim = this->rim](const Jet& x, const Jet& y) { return x * x + y * y - Jet(rim * rim); });
  }
  return result;
}

CircularForm gaussianShoal(double h0, double a, double sigma)
{
  return { specOf("shoal:kind=gauss", { { "h0", h0 }, { "a", a }, { "sg", sigma } }),
    [=](Real r) { return h0 - a * std::exp(-r * r / (2.0L * sigma * sigma)); },
    [=](const Jet& w, unsigned) { return Jet(h0) - a * exp(-w / (2.0 * sigma * sigma)); }, 0.0, sigma };
}

CircularForm polynomialShoal(double h0, double a, double R)
{
  return { specOf("shoal:kind=poly3", { { "h0", h0 }, { "a", a }, { "R", R } }),
    [=](Real r)
    {
      const Real u = 1.0L - r * r / (static_cast<Real>(R) * R);
      return r < R ? h0 - a * u * u * u : static_cast<Real>(h0);
    },
    [=](const Jet& w, unsigned region)
    {
      const Jet u = Jet(1.0) - w / (R * R);
      return region ? Jet(h0) : Jet(h0) - a * u * u * u;
    },
    R, 0.4 * R };
}

CircularForm conicalIsland(double s, double rs, double rt)
{
  return { specOf("island:kind=conical", { { "s", s }, { "rs", rs }, { "rt", rt } }),
    [=](Real r) { return s * (std::min<Real>(r, rt) - rs); },
    [=](const Jet& w, unsigned region) { return region ? Jet(s * (rt - rs)) : s * (sqrt(w) - Jet(rs)); }, rt,
    0.5 * rs };
}

CircularForm parabolicIsland(double h0, double R)
{
  return { specOf("island:kind=parabolic", { { "h0", h0 }, { "R", R } }),
    [=](Real r)
    {
      const Real share = std::min<Real>(r, R) / R;
      return h0 * share * share;
    },
    [=](const Jet& w, unsigned region) { return region ? Jet(h0) : h0 / (R * R) * w; }, R, 0.1 * R };
}

}
