#include "sim/sections/VortexSection.h"

#include "sim/SurfZone.h"

namespace swellray
{

namespace
{

constexpr double SmallestRatio = 1.73;
constexpr double LargestRatio = 4.43;

// The long axis falls forward.
constexpr double Tilt = -40.0 * Pi / 180.0;

// Heights over that of the wave: of the floor of the hollow above the trough, and of the lip's thickness over half the
// height of the vortex.
constexpr double FloorHeight = 0.08;
constexpr double LipThickness = 0.35;

// Angles on the vortex from its forward end, anticlockwise: where the tip of the lip comes to, and where the floor ends.
constexpr double TipAngle = 0.05 * Pi;
constexpr double FloorAngle = 1.75 * Pi;

// Share of the curl after which the front stands against the vortex; only then the lip goes over it.
constexpr double Standing = 0.3;

// Share of a broken wave (CrestState::roller) at which none of its lip is left.
constexpr double LipGone = 0.6;

// Phases where the parts of a wave begin and end.
constexpr double BackBegin = -0.75 * Pi;
constexpr double TopBegin = -0.1 * Pi;
constexpr double TopEnd = 0.2 * Pi;
constexpr double FrontEnd = 0.6 * Pi;

double smoothStep(double t)
{
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

Dual smoothStep(const Dual& t)
{
  return t * t * (3.0 - 2.0 * t);
}

}

double VortexSection::lengthToWidth(double slope)
{
  return slope > 0.0 ? std::clamp(vortexRatioLine(slope), SmallestRatio, LargestRatio) : LargestRatio;
}

double VortexSection::frontPhase() const
{
  return FrontEnd;
}

VortexSection::Part VortexSection::part(double phase)
{
  if (phase < BackBegin || phase > FrontEnd)
  {
    return Part::Flat;
  }
  return phase < TopBegin ? Part::Back : phase <= TopEnd ? Part::Top : Part::Front;
}

VortexSection::Vortex VortexSection::vortex(const CrestState& crest) const
{
  Vortex vortex;
  const double steepness = crest.height * crest.wavenumber / (2.0 * Pi);
  // Beyond the threshold the curl is complete at twice its steepness.
  const double steep = steepness / this->Values.threshold - 1.0;
  // Where the wave forms again the lip goes back into the face first and the hollow closes.
  const double left = crest.plunge > 0.0 ? crest.roller : 1.0;
  const double lip = Standing + (1.0 - Standing) * smoothStep((left - LipGone) / (1.0 - LipGone));
  vortex.curl = std::clamp(std::max(std::min(crest.plunge, 1.0) * lip, steep), 0.0, 1.0);
  if (!(vortex.curl > 0.0))
  {
    return vortex;
  }
  double size = left;
  if (crest.plunge > 1.0 && crest.plungeHeight > 0.0)
  {
    size *= std::clamp(crest.height / crest.plungeHeight, 0.0, 1.0);
  }
  const double floor = FloorHeight * size;
  const double half = size * crest.height * (1.0 - FloorHeight) / (2.0 + LipThickness); // of its height
  const double ratio = lengthToWidth(crest.slope);
  vortex.width = 2.0 * half / std::hypot(ratio * std::sin(Tilt), std::cos(Tilt));
  vortex.length = ratio * vortex.width;
  vortex.forward = 0.5 * vortex.width * std::hypot(ratio * std::cos(Tilt), std::sin(Tilt));
  vortex.up = floor * crest.height + half;
  return vortex;
}

VortexSection::Shape VortexSection::shape(const CrestState& crest) const
{
  Shape shape;
  shape.vortex = this->vortex(crest);
  const Vortex& vortex = shape.vortex;
  if (vortex.curl > 0.0)
  {
    shape.standing = smoothStep(vortex.curl / Standing);
    // The crest is above the highest point of the vortex.
    shape.crestAngle = std::atan2(vortex.width * std::cos(Tilt), vortex.length * std::sin(Tilt));
    shape.tipAngle =
      shape.crestAngle + (TipAngle - shape.crestAngle) * smoothStep((vortex.curl - Standing) / (1.0 - Standing));
    const double half = 0.5 * std::hypot(vortex.length * std::sin(Tilt), vortex.width * std::cos(Tilt));
    shape.lip = half > 0.0 ? (crest.height - vortex.up) / half : 1.0;
  }
  return shape;
}

Displacement VortexSection::displacement(const Shape& shape, const SectionPlace& place, const Dual& phase) const
{
  const double radius = 0.5 * place.height;
  const double k = place.wavenumber;
  const double peaking = this->Values.steepness * place.ripeness * place.ripeness;
  const SineCosine turn = sineCosine(phase);
  const Displacement shallow{ -(peaking / k) * turn.sine, 0.5 * peaking * radius + radius * turn.cosine };
  const Vortex& vortex = shape.vortex;
  if (!(vortex.curl > 0.0) || phase.value < BackBegin)
  {
    return shallow;
  }

  const double trough = (0.5 * peaking - 1.0) * radius;
  const auto onVortex = [&](const Dual& angle, const Dual& size)
  {
    const SineCosine at = sineCosine(angle);
    const Dual a = 0.5 * vortex.length * (size * at.cosine);
    const Dual b = 0.5 * vortex.width * (size * at.sine);
    return Displacement{ vortex.forward + std::cos(Tilt) * a - std::sin(Tilt) * b,
      vortex.up + trough + std::sin(Tilt) * a + std::cos(Tilt) * b };
  };
  const Dual undisturbed = phase / k;
  Displacement curled;
  if (phase.value > FrontEnd)
  {
    // From the floor of the hollow to the trough ahead.
    const Displacement floor = onVortex(FloorAngle, 1.0);
    const Dual way = (phase - FrontEnd) / (Pi - FrontEnd);
    curled = { floor.along + (Pi / k - floor.along.value) * way,
      floor.up + (trough - floor.up.value) * smoothStep(way) };
  }
  else if (phase.value > TopEnd)
  {
    const Dual way = (phase - TopEnd) / (FrontEnd - TopEnd);
    curled = onVortex(shape.tipAngle + (FloorAngle - shape.tipAngle) * way, 1.0);
  }
  else if (phase.value > 0.0)
  {
    const Dual way = phase / TopEnd;
    curled = onVortex(
      shape.crestAngle + (shape.tipAngle - shape.crestAngle) * way, shape.lip + (1.0 - shape.lip) * (way * way));
  }
  else
  {
    const Displacement crest = onVortex(shape.crestAngle, shape.lip);
    const double crestUp = (0.5 * peaking + 1.0) * radius;
    const Dual share = smoothStep((phase - BackBegin) / -BackBegin);
    curled = { shallow.along + undisturbed + crest.along.value * share,
      shallow.up + (crest.up.value - crestUp) * share };
  }
  return { shallow.along + shape.standing * (curled.along - undisturbed - shallow.along),
    shallow.up + shape.standing * (curled.up - shallow.up) };
}

}
