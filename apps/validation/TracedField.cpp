#include "TracedField.h"

#include "sim/Angles.h"
#include "sim/RayQuantities.h"
#include "sim/SheetSearch.h"

#include <algorithm>
#include <complex>
#include <iterator>

namespace swellray::validation
{

TracedField::TracedField(
  const Seafloor& seafloor, const IncidentWave& wave, const TraceOptions& trace, HeightOptions options)
  : Field(traceWaves(seafloor, wave, trace))
{
  const std::size_t points = this->Field.points.size();
  const auto make = [points](std::vector<double>& values, std::size_t components = 1)
  {
    values.resize(points * components);
    return values.data();
  };
  std::vector<double> depth, groupSpeed, shoaling, krSpacing, krTube;
  RayQuantities quantities;
  quantities.position = make(this->Position, 3);
  quantities.direction = make(this->Direction, 3);
  quantities.phase = make(this->Phase);
  quantities.wavenumber = make(this->Wavenumber);
  quantities.tubeWidth = make(this->Tube);
  quantities.depth = make(depth);
  quantities.groupSpeed = make(groupSpeed);
  quantities.shoaling = make(shoaling);
  quantities.krSpacing = make(krSpacing);
  quantities.krTube = make(krTube);
  this->Caustics.resize(points);
  this->State.resize(points);
  quantities.caustics = this->Caustics.data();
  quantities.state = this->State.data();
  computeRayQuantities(this->Field, wave, trace.waterLevel, quantities);

  options.breaking = BreakingRule::None;
  make(this->Refraction);
  make(this->Height);
  this->Breaking.assign(points, 0);
  RayHeights heights;
  std::size_t caustic = 0;
  for (std::size_t ray = 0; ray < this->Field.rays.size(); ++ray)
  {
    const std::size_t at = this->Field.offsets[ray];
    RayProfile profile;
    profile.count = this->Field.pointCount(ray);
    profile.position = this->Position.data() + 3 * at;
    profile.depth = depth.data() + at;
    profile.wavenumber = this->Wavenumber.data() + at;
    profile.groupSpeed = groupSpeed.data() + at;
    profile.shoaling = shoaling.data() + at;
    profile.krSpacing = krSpacing.data() + at;
    profile.krTube = krTube.data() + at;
    profile.state = this->State.data() + at;
    profile.phase = this->Phase.data() + at;
    profile.caustics = this->Field.caustics.data() + caustic;
    while (caustic + profile.causticCount < this->Field.caustics.size() &&
      this->Field.caustics[caustic + profile.causticCount].ray == static_cast<std::int32_t>(ray))
    {
      ++profile.causticCount;
    }
    caustic += profile.causticCount;
    computeHeights(profile, wave, options, heights);
    std::copy(heights.refraction.begin(), heights.refraction.end(), this->Refraction.begin() + static_cast<long>(at));
    std::copy(heights.height.begin(), heights.height.end(), this->Height.begin() + static_cast<long>(at));
    const RayInfo& info = this->Field.rays[ray];
    this->Lambda.push_back(info.launchParameter);
    this->Segment.push_back(info.launchSegment);
    this->Parent.push_back(info.parent);
    this->Lee.push_back(info.lee ? 1 : 0);
    this->End.push_back(static_cast<std::uint8_t>(info.endReason));
  }
  this->Offsets.assign(this->Field.offsets.begin(), this->Field.offsets.end());
}

SheetRays TracedField::sheetRays() const
{
  SheetRays rays;
  rays.lines.rays = this->Field.rays.size();
  rays.lines.offsets = this->Offsets.data();
  rays.lines.positions = this->Position.data();
  rays.lines.phase = this->Phase.data();
  rays.lines.launchParameter = this->Lambda.data();
  rays.lines.launchSegment = this->Segment.data();
  rays.parent = this->Parent.data();
  rays.lee = this->Lee.data();
  rays.endReason = this->End.data();
  rays.direction = this->Direction.data();
  rays.wavenumber = this->Wavenumber.data();
  rays.height = this->Height.data();
  rays.caustics = this->Caustics.data();
  rays.breaking = this->Breaking.data();
  rays.state = this->State.data();
  rays.refraction = this->Refraction.data();
  rays.tubeWidth = this->Tube.data();
  rays.touched = this->Field.caustics.data();
  rays.touchedCount = this->Field.caustics.size();
  return rays;
}

RayMap TracedField::at(const std::vector<glm::dvec2>& places, CombineRule rule) const
{
  return sampleRays(RaySheets(this->sheetRays(), this->Field.maxSpacing), places, nullptr, rule);
}

std::vector<double> TracedField::plainSum(const std::vector<glm::dvec2>& places) const
{
  const RaySheets sheets(this->sheetRays(), this->Field.maxSpacing);
  std::vector<std::complex<double>> sums(places.size(), 0.0);
  for (const SheetHit& hit : findSheets(sheets, places, nullptr, {}))
  {
    sums[hit.place] += std::polar(hit.wave.branch, hit.wave.phase - 0.5 * Pi * hit.wave.caustics);
  }
  std::vector<double> heights;
  std::transform(sums.begin(), sums.end(), std::back_inserter(heights), [](const auto& sum) { return std::abs(sum); });
  return heights;
}

}
