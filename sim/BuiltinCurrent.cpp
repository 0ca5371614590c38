#include "sim/BuiltinCurrent.h"

#include "sim/Angles.h"
#include "sim/forms/FormCatalogue.h"
#include "sim/forms/FormKeys.h"

#include <cmath>

namespace swellray
{

namespace
{

using namespace formkeys;

constexpr double LargestSpeed = 20.0; // m/s

/**
 * A parallel current: along a fixed direction, its speed a function of the distance s to the right of an axis.
 */
class ParallelCurrent : public Current
{
public:
  ParallelCurrent(const glm::dvec2& onAxis, double heading)
    : OnAxis(onAxis)
    , Along(std::sin(radians(heading)), std::cos(radians(heading)))
  {
  }

  void evaluate(const glm::dvec2& p, CurrentSample& sample) const final
  {
    const glm::dvec2 right(this->Along.y, -this->Along.x);
    const glm::dvec2 offset = p - this->OnAxis;
    double speed = 0.0;
    double slope = 0.0;
    double curve = 0.0;
    this->profile(offset.x * right.x + offset.y * right.y, speed, slope, curve);
    sample.velocity = speed * this->Along;
    sample.dx = slope * right.x * this->Along;
    sample.dy = slope * right.y * this->Along;
    sample.dxx = curve * right.x * right.x * this->Along;
    sample.dxy = curve * right.x * right.y * this->Along;
    sample.dyy = curve * right.y * right.y * this->Along;
  }

private:
  /** Speed at s, m/s, and its first two derivatives. */
  virtual void profile(double s, double& speed, double& slope, double& curve) const = 0;

  glm::dvec2 OnAxis;
  glm::dvec2 Along;
};

class JetCurrent final : public ParallelCurrent
{
public:
  JetCurrent(const glm::dvec2& onAxis, double heading, double speed, double width)
    : ParallelCurrent(onAxis, heading)
    , Speed(speed)
    , Width(width)
  {
  }

  double featureLength() const override { return this->Width; }

private:
  void profile(double s, double& speed, double& slope, double& curve) const override
  {
    const double t = s / this->Width;
    speed = this->Speed * std::exp(-t * t);
    slope = -2.0 * t / this->Width * speed;
    curve = (4.0 * t * t - 2.0) / (this->Width * this->Width) * speed;
  }

  double Speed;
  double Width;
};

class ShearCurrent final : public ParallelCurrent
{
public:
  ShearCurrent(const glm::dvec2& onAxis, double heading, double speed, double rate)
    : ParallelCurrent(onAxis, heading)
    , Speed(speed)
    , Rate(rate)
  {
  }

  // A straight line holds no surprise at any length.
  double featureLength() const override { return LargestDistance; }

private:
  void profile(double s, double& speed, double& slope, double& curve) const override
  {
    speed = this->Speed + this->Rate * s;
    slope = this->Rate;
    curve = 0.0;
  }

  double Speed;
  double Rate;
};

class EddyCurrent final : public Current
{
public:
  EddyCurrent(const glm::dvec2& centre, double speed, double radius)
    : Centre(centre)
    , Speed(speed)
    , Radius(radius)
  {
  }

  double featureLength() const override { return this->Radius; }

  void evaluate(const glm::dvec2& p, CurrentSample& sample) const override
  {
    // In radii: U = U0 E (-y, x), E = exp((1 - x^2 - y^2)/2), so that E_x = -x E and E_xx = (x^2 - 1) E.
    const double x = (p.x - this->Centre.x) / this->Radius;
    const double y = (p.y - this->Centre.y) / this->Radius;
    const double speed = this->Speed * std::exp(0.5 * (1.0 - x * x - y * y));
    const double rate = speed / this->Radius;
    const double curve = rate / this->Radius;
    sample.velocity = speed * glm::dvec2(-y, x);
    sample.dx = rate * glm::dvec2(x * y, 1.0 - x * x);
    sample.dy = rate * glm::dvec2(y * y - 1.0, -x * y);
    sample.dxx = curve * glm::dvec2(y - x * x * y, x * x * x - 3.0 * x);
    sample.dxy = curve * glm::dvec2(x - x * y * y, x * x * y - y);
    sample.dyy = curve * glm::dvec2(3.0 * y - y * y * y, x * y * y - x);
  }

private:
  glm::dvec2 Centre;
  double Speed;
  double Radius;
};

FormKey speed(const std::string& symbol, double value, const std::string& description)
{
  return number("speed", symbol, "m/s", value, -LargestSpeed, LargestSpeed, description);
}

FormKey position(const std::string& name, const std::string& description)
{
  return formkeys::position(name, 0.0, description);
}

FormKey heading()
{
  return number("heading", "", "deg", 0.0, -360.0, 360.0, "nautical direction that it flows to; 0: U = (0, V)");
}

const FormCatalogue<Current>& catalogue()
{
  static const FormCatalogue<Current> all("current",
    {
      { { "jet", "jet", "V = V0 exp(-(x/w)^2), x: distance to the right of its axis", "",
          { speed("V0", 2.0, "speed on the axis"), length("width", "w", 200.0, "half width at 1/e of the speed"),
            heading(), position("xc", "a point on the axis, east"), position("yc", "a point on the axis, north") },
          270.0, 10.0 },
        [](const FormValues& v) -> std::unique_ptr<Current>
        { return std::make_unique<JetCurrent>(glm::dvec2(v["xc"], v["yc"]), v["heading"], v["speed"], v["width"]); } },
      { { "shear", "current of constant shear", "V = V0 + S x, x: distance to the right of its axis", "",
          { speed("V0", 0.0, "speed on the axis"), number("rate", "S", "1/s", 0.001, -1.0, 1.0, "shear"), heading(),
            position("xc", "a point on the axis, east"), position("yc", "a point on the axis, north") },
          270.0, 10.0 },
        [](const FormValues& v) -> std::unique_ptr<Current>
        { return std::make_unique<ShearCurrent>(glm::dvec2(v["xc"], v["yc"]), v["heading"], v["speed"], v["rate"]); } },
      { { "eddy", "eddy, r from its centre", "U = U0 (r/R) exp((1 - (r/R)^2)/2) around the centre, anticlockwise", "",
          { speed("U0", 1.5, "largest speed, negative: clockwise"),
            length("radius", "R", 300.0, "distance from the centre at which the speed is largest"),
            position("xc", "centre, east"), position("yc", "centre, north") },
          270.0, 10.0 },
        [](const FormValues& v) -> std::unique_ptr<Current>
        { return std::make_unique<EddyCurrent>(glm::dvec2(v["xc"], v["yc"]), v["speed"], v["radius"]); } },
    });
  return all;
}

}

const std::vector<FormDescription>& builtinCurrents()
{
  return catalogue().descriptions();
}

bool isBuiltinCurrent(const std::string& spec)
{
  return catalogue().has(spec);
}

bool resemblesBuiltinCurrent(const std::string& spec)
{
  return catalogue().resembles(spec);
}

std::unique_ptr<Current> makeBuiltinCurrent(const std::string& spec)
{
  return catalogue().make(spec);
}

}
