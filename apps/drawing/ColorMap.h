#pragma once

#include <array>
#include <vector>

namespace swellray::drawing
{

/** Red, green, blue, 0 to 1, sRGB. */
using Rgb = std::array<double, 3>;

/** A colour of CIE 1976 L*a*b* (D65): lightness 0 to 100, green-red, blue-yellow. */
struct Lab
{
  double lightness = 0.0;
  double a = 0.0;
  double b = 0.0;
};

/** The nearest colour that a screen shows. */
Rgb toRgb(const Lab& lab);

/**
 * A scale of colours between anchors in L*a*b*, in which equal steps look equally large, so that equal
 * steps of the quantity do too.
 */
class ColorMap
{
public:
  explicit ColorMap(std::vector<Lab> anchors)
    : Anchors(std::move(anchors))
  {
  }

  /** Colour at t, 0 to 1; outside of that the colours of the ends. */
  Lab lab(double t) const;
  Rgb rgb(double t) const { return toRgb(this->lab(t)); }

private:
  std::vector<Lab> Anchors;
};

/** Depth: pale in the shallows to deep blue; 0 at the shore, 1 at the deepest. */
const ColorMap& waterMap();

/** Elevation of land: muted tones. */
const ColorMap& landMap();

/** Heights and other quantities along rays: pale yellow over orange to dark purple, readable over blue. */
const ColorMap& rayMap();

}
