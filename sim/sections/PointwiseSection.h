#pragma once

#include "sim/sections/Dual.h"
#include "sim/sections/WaveSection.h"

namespace swellray
{

/** A displacement that knows its rate by the phase. */
struct Displacement
{
  Dual along;
  Dual up;
};

/**
 * A section that displaces its places one by one. Section has a type Shape, what all places of a wave share, with
 *   Shape shape(const CrestState&) const
 *   Displacement displacement(const Shape&, const SectionPlace&, const Dual& phase) const
 * which is inlined into the loop.
 */
template <class Section>
class PointwiseSection : public WaveSection
{
public:
  void displace(const CrestState& crest, const SectionPlaces& places, const SectionPoints& points) const final
  {
    const auto& self = static_cast<const Section&>(*this);
    const auto shape = self.shape(crest);
    const auto forPlaces = [&](const auto& displacementOf)
    {
      for (std::size_t i = 0; i < places.count; ++i)
      {
        const Displacement moved = displacementOf(SectionPlace{ places.phase[i], places.height[i], places.wavenumber[i],
          places.depth[i], places.slope[i], places.ripeness[i] });
        points.along[i] = moved.along.value;
        points.up[i] = moved.up.value;
        points.alongRate[i] = moved.along.rate;
        points.upRate[i] = moved.up.rate;
      }
    };
    if (!(crest.plunge > 0.0) || crest.roller >= 1.0)
    {
      forPlaces([&](const SectionPlace& place) { return self.displacement(shape, place, Dual(place.phase, 1.0)); });
      return;
    }
    // A wave that forms again is on its way from its broken shape to that of a whole one.
    CrestState whole = crest;
    whole.plunge = 0.0;
    const auto wholeShape = self.shape(whole);
    forPlaces(
      [&](const SectionPlace& place)
      {
        const Dual phase(place.phase, 1.0);
        const Displacement broken = self.displacement(shape, place, phase);
        const Displacement reformed = self.displacement(wholeShape, place, phase);
        return Displacement{ reformed.along + crest.roller * (broken.along - reformed.along),
          reformed.up + crest.roller * (broken.up - reformed.up) };
      });
  }

  /** For sections whose places share nothing. */
  struct Shape
  {
  };
  Shape shape(const CrestState&) const { return {}; }
};

}
