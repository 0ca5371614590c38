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
    for (std::size_t i = 0; i < places.count; ++i)
    {
      const SectionPlace place{ places.phase[i], places.height[i], places.wavenumber[i], places.depth[i],
        places.slope[i], places.ripeness[i] };
      const Displacement moved = self.displacement(shape, place, Dual(place.phase, 1.0));
      points.along[i] = moved.along.value;
      points.up[i] = moved.up.value;
      points.alongRate[i] = moved.along.rate;
      points.upRate[i] = moved.up.rate;
    }
  }

  /** For sections whose places share nothing. */
  struct Shape
  {
  };
  Shape shape(const CrestState&) const { return {}; }
};

}
