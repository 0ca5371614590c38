#pragma once

#include <array>
#include <string>
#include <utility>
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

/**
 * Scales for quantities along rays by name: `warm` (rayMap), `viridis` (S. van der Walt and N. Smith, SciPy conference
 * 2015) and `cividis` (J. R. Nunez, C. R. Anderton and R. S. Renslow, PLoS ONE 13(7), 2018), these two by anchors of our own
 * measured in L*a*b*. Lightness goes one way along each of them, so that they read the same to any eye and in grey.
 */
const std::vector<std::pair<std::string, const ColorMap*>>& quantityMaps();

}
