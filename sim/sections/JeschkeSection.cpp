#include "sim/sections/JeschkeSection.h"

namespace swellray
{

namespace
{

// Length of the hump over its height: 1 over k2 k7, at the end of the round phase and of the breaking one.
constexpr double LengthAtOnset = 5.0;
constexpr double LengthOverCrest = 4.0;

}

JeschkeSection::Shape JeschkeSection::round(double t)
{
  Shape shape;
  shape.k7 = 0.8 * t;
  return shape;
}

JeschkeSection::Shape JeschkeSection::breaking(double t)
{
  const double dent = std::pow(t, 0.85);
  const double turn = std::pow(t, 1.5);
  Shape shape;
  shape.front = { 1.0 + t, 0.25 * (1.0 - dent), 0.25 * dent, 4.0, turn, 16.0 };
  shape.back = { 1.0 - 0.3 * t, 0.25, 0.0, 0.0, turn, 4.0 };
  shape.k7 = 0.2 * (4.0 + t);
  return shape;
}

JeschkeSection::Shape JeschkeSection::collapsing(double t)
{
  Shape shape;
  shape.front = { 2.0, 0.0, 0.25 * (1.0 - t), 4.0, 1.0, 16.0 };
  shape.back = { 0.7 - 0.2 * t, 0.25, 0.5 * std::pow(t, 0.7), 40.0, 1.0, 4.0 };
  shape.k7 = 1.0 - t;
  return shape;
}

Displacement JeschkeSection::curve(const Shape& shape, const Dual& s)
{
  const bool isBack = s.value <= 0.5;
  const Half& half = isBack ? shape.back : shape.front;
  const Dual fromEnd = isBack ? 2.0 * s : 2.0 * s - 1.0;
  const Dual raised = power(fromEnd, half.k1);
  const Dual s2 = isBack ? raised : 1.0 - raised;
  const Dual s1 = isBack ? 0.5 * raised : 0.5 * (1.0 + raised);
  Dual z = 0.5 * half.k2 * (1.0 + sineCosine(Pi * (s2 - 1.0)).cosine);
  if (half.k3 > 0.0)
  {
    z = z + half.k3 * power(s2, half.k4);
  }
  const Dual level = 0.5 - s1;
  if (half.k5 == 0.0)
  {
    return { s1, z };
  }
  const SineCosine turn = sineCosine(0.5 * Pi * half.k5 * power(s2, half.k6));
  return { 0.5 - level * turn.cosine + z * turn.sine, level * turn.sine + z * turn.cosine };
}

double JeschkeSection::humpWidth(double height, double wavenumber, double ripeness)
{
  const double wavelength = 2.0 * Pi / wavenumber;
  const double breaking = LengthAtOnset * height;
  // In the square of the ripeness: swell keeps its sine until it shoals.
  return breaking < wavelength ? wavelength * std::pow(breaking / wavelength, ripeness * ripeness) : wavelength;
}

JeschkeSection::Shape JeschkeSection::shape(const CrestState& crest) const
{
  Shape shape;
  if (!(crest.plunge > 0.0))
  {
    shape = round(std::clamp(crest.ripeness, 0.0, 1.0));
    shape.width = humpWidth(crest.height, crest.wavenumber, crest.ripeness);
    // k7 grows with the wave in the paper; here the traced height does.
    shape.k7 = 0.8;
    shape.height = LengthAtOnset * crest.height;
  }
  else if (crest.plunge < 1.0)
  {
    shape = breaking(crest.plunge);
    shape.width = LengthOverCrest * crest.height / shape.k7;
    shape.height = shape.width;
  }
  else
  {
    const double left = crest.plungeHeight > 0.0 ? std::clamp(crest.height / crest.plungeHeight, 0.0, 1.0) : 0.0;
    shape = collapsing(1.0 - left);
    shape.width = LengthOverCrest * crest.plungeHeight;
    shape.height = shape.width;
  }
  return shape;
}

Displacement JeschkeSection::displacement(const Shape& shape, const SectionPlace& place, const Dual& phase) const
{
  const HumpLayout layout(shape.width, place.wavenumber);
  const Dual undisturbed = phase / place.wavenumber;
  const double round = std::min(humpWidth(place.height, place.wavenumber, place.ripeness), 2.0 * layout.half);
  const double trough = -0.25 * place.height * round / layout.half;
  if (!layout.onHump(phase.value))
  {
    return { layout.trough(phase) - undisturbed, trough };
  }
  const Displacement point = curve(shape, layout.position(phase) + 0.5);
  return { layout.width * (point.along - 0.5) - undisturbed, shape.height * shape.k7 * point.up + trough };
}

}
