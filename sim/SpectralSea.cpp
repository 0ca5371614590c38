#include "sim/SpectralSea.h"

#include "sim/SpectralSurf.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

namespace swellray
{

namespace
{

SeaParameters unknownSea()
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  return { none, none, none, none, none, none, none };
}

void scale(DirectionalSpectrum& spectrum, double share)
{
  for (double& density : spectrum.density)
  {
    density *= share;
  }
}

}

void SpectralSeaOptions::validate() const
{
  rays.validate();
  if (breaking != BreakingRule::None && breaking != BreakingRule::Gamma && !ofRandomWaves(breaking))
  {
    throw std::invalid_argument(std::string("a sea has no breaking rule ") + breakingRuleName(breaking) +
      "; it has none, gamma, battjes-janssen and baldock");
  }
  if (gamma && !(*gamma > 0.0 && std::isfinite(*gamma)))
  {
    throw std::invalid_argument("gamma must be above 0");
  }
}

bool saturate(DirectionalSpectrum& spectrum, double depth, double gamma)
{
  const double height = seaParameters(spectrum).significantHeight;
  if (!(height > gamma * depth))
  {
    return false;
  }
  const double share = gamma * depth / height;
  scale(spectrum, share * share);
  return true;
}

namespace
{

// Seas at so many places; `originsOf` gives the origins of one, on any thread.
std::vector<PlaceSea> transformPlaces(const SpectralSeaOptions& options, const DirectionalSpectrum& offshore,
  std::size_t count, const std::function<SpectralOrigins(std::size_t)>& originsOf, const SpectralSurf* surf,
  const Execution& execution, std::vector<DirectionalSpectrum>* spectra)
{
  options.validate();
  if (ofRandomWaves(options.breaking) && !surf)
  {
    throw std::invalid_argument(std::string("breaking by ") + breakingRuleName(options.breaking) +
      " needs rays along the way, which kept ones are not");
  }
  std::vector<PlaceSea> result(count);
  for (PlaceSea& sea : result)
  {
    sea.parameters = unknownSea();
  }
  if (spectra)
  {
    spectra->assign(count, DirectionalSpectrum());
  }
  // Batches between which progress is told; small ones, as a place is long work.
  const std::size_t batches = std::clamp<std::size_t>(count / 16, 1, 200);
  for (std::size_t batch = 0; batch < batches; ++batch)
  {
    const std::size_t first = count * batch / batches;
    const std::size_t last = count * (batch + 1) / batches;
    execution.forRange(last - first,
      [&](std::size_t begin, std::size_t end)
      {
        DirectionalSpectrum spectrum;
        for (std::size_t i = first + begin; i < first + end; ++i)
        {
          PlaceSea& sea = result[i];
          const SpectralOrigins origins = originsOf(i);
          sea.depth = origins.depth;
          if (origins.headings.empty())
          {
            continue;
          }
          sea.rays = origins.headings.size();
          sea.steps = origins.steps;
          SpectralTransfer(options.rays, offshore.grid, origins).apply(offshore.density, spectrum);
          sea.breaking = options.breaking == BreakingRule::Gamma &&
            saturate(spectrum, sea.depth, options.gamma.value_or(SaturationGamma));
          if (surf)
          {
            const SpectralSurf::Outcome outcome = surf->at(origins.place, sea.depth, spectrum);
            sea.breaking = outcome.breaking;
            sea.rays += outcome.rays;
            sea.steps += outcome.steps;
            scale(spectrum, outcome.share);
          }
          sea.known = true;
          sea.parameters = seaParameters(spectrum);
          if (spectra)
          {
            (*spectra)[i] = spectrum;
          }
        }
      });
    if (!execution.report(static_cast<double>(batch + 1) / static_cast<double>(batches)))
    {
      break;
    }
  }
  return result;
}

}

std::vector<PlaceSea> transformSea(const BackwardTracer& tracer, const SpectralSeaOptions& options,
  const DirectionalSpectrum& offshore, const std::vector<glm::dvec2>& places, const Execution& execution,
  std::vector<DirectionalSpectrum>* spectra)
{
  std::optional<SpectralSurf> surf;
  if (ofRandomWaves(options.breaking))
  {
    options.validate();
    surf.emplace(tracer, options.rays, offshore, options.breaking, options.gamma);
  }
  return transformPlaces(
    options, offshore, places.size(),
    [&](std::size_t i) { return traceOrigins(tracer, options.rays, { places[i] }).front(); }, surf ? &*surf : nullptr,
    execution, spectra);
}

std::vector<PlaceSea> transformSea(const SpectralSeaOptions& options, const DirectionalSpectrum& offshore,
  const std::vector<SpectralOrigins>& origins, const Execution& execution, std::vector<DirectionalSpectrum>* spectra)
{
  return transformPlaces(
    options, offshore, origins.size(), [&](std::size_t i) { return origins[i]; }, nullptr, execution, spectra);
}

}
