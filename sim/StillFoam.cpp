#include "sim/StillFoam.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace swellray
{

namespace
{

// Places that are looked up at once; what they find is put together in their order.
constexpr std::size_t PlacesAtOnce = 4096;

}

StillFoam::StillFoam(
  const std::vector<const SurfaceFunction*>& waves, const std::vector<glm::dvec2>& places, const Execution& execution)
  : Covered(places.size(), 0)
  , Offsets(places.size() + 1, 0)
{
  if (waves.empty())
  {
    throw std::invalid_argument("foam on still water needs at least one wave");
  }
  for (const SurfaceFunction* wave : waves)
  {
    const SurfaceOptions& options = wave->surface().options();
    FoamOptions foam;
    foam.period = options.period;
    foam.wavelength = options.wavelength;
    foam.seed = options.seed;
    foam.groups = options.groups;
    this->Waves.push_back(foam);
  }
  const std::size_t blocks = (places.size() + PlacesAtOnce - 1) / PlacesAtOnce;
  std::vector<std::vector<Sheet>> found(blocks);
  execution.forRange(blocks,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<SheetPlace> sheets;
      for (std::size_t block = begin; block < end; ++block)
      {
        const std::size_t last = std::min(places.size(), (block + 1) * PlacesAtOnce);
        for (std::size_t i = block * PlacesAtOnce; i < last; ++i)
        {
          const std::size_t before = found[block].size();
          for (std::size_t w = 0; w < waves.size(); ++w)
          {
            waves[w]->cover(places[i], sheets);
            this->Covered[i] = this->Covered[i] || !sheets.empty() ? 1 : 0;
            for (const SheetPlace& sheet : sheets)
            {
              const auto& since = sheet.breakingPhase;
              if (std::any_of(since.begin(), since.end(), [](double phase) { return !std::isnan(phase); }))
              {
                std::array<double, 3> weight = sheet.weight;
                for (std::size_t c = 0; c < 3; ++c)
                {
                  weight[c] *= sheet.foamShare[c];
                }
                found[block].push_back({ static_cast<std::uint32_t>(w), sheet.phase, sheet.groupTime, sheet.brokenShare,
                  weight, since, sheet.launchParameter });
              }
            }
          }
          this->Offsets[i + 1] = found[block].size() - before;
        }
      }
    });
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    this->Foaming += this->Offsets[i + 1] > 0 ? 1 : 0;
    this->Offsets[i + 1] += this->Offsets[i];
  }
  this->Sheets.reserve(this->Offsets.back());
  for (const auto& block : found)
  {
    this->Sheets.insert(this->Sheets.end(), block.begin(), block.end());
  }
}

void StillFoam::at(double time, double life, double variation, float* foam, const Execution& execution) const
{
  std::vector<FoamOptions> options = this->Waves;
  for (FoamOptions& wave : options)
  {
    wave.life = life;
    wave.variation = variation;
    wave.validate();
  }
  execution.forRange(this->Covered.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        double most = 0.0;
        for (std::size_t s = this->Offsets[i]; s < this->Offsets[i + 1]; ++s)
        {
          const Sheet& sheet = this->Sheets[s];
          double sum = 0.0;
          for (std::size_t c = 0; c < 3; ++c)
          {
            sum += sheet.weight[c] *
              foamAt(sheet.phase, sheet.breakingPhase[c], sheet.launchParameter[c], time, options[sheet.wave],
                sheet.groupTime, sheet.brokenShare);
          }
          most = std::max(most, sum);
        }
        foam[i] = this->Covered[i] ? static_cast<float>(most) : std::numeric_limits<float>::quiet_NaN();
      }
    });
}

}
