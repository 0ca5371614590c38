#include "sim/RayMap.h"

#include "sim/Angles.h"
#include "sim/Bins.h"
#include "sim/Caustic.h"
#include "sim/SheetSearch.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace swellray
{

namespace
{

// Rows of a map that one piece of work covers.
constexpr std::size_t RowsAtOnce = 8;

// Below this share of its parts a mean direction is rounding.
constexpr double NoMean = 1e-12;

// Geometric heights are taken to be right up to this many times what the modulus on a sheet says.
constexpr double LargestBranch = 1.5;

// Branches of a fold differ by no more than this times z^(1/2), of their sum, where triangles are too coarse for their tubes.
constexpr double LargestDifference = 0.5;

// Next to a caustic the sheets' phases are off by less than this, rad.
constexpr double Ragged = 0.7;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

// What a strip along a caustic brings to a place.
struct FoldHit
{
  std::size_t place = 0;
  FoldShare wave;
};

// What beams bring to a place.
struct BeamHit
{
  std::size_t place = 0;
  BeamShare wave;
};

// Whatever makes up the waves of places.
struct Hits
{
  std::vector<SheetHit> sheets;
  std::vector<FoldHit> folds;
  std::vector<BeamHit> beams;

  void clear()
  {
    this->sheets.clear();
    this->folds.clear();
    this->beams.clear();
  }
};

void resize(RayMap& map, std::size_t places)
{
  map.height.assign(places, NotANumber);
  map.directionFrom.assign(places, NotANumber);
  map.wavelength.assign(places, NotANumber);
  map.breaking.assign(places, 0);
  map.lee.assign(places, 0);
  map.count.assign(places, 0);
}

// The sheet of one caustic less that is nearest in phase before a sheet, or the sheet past the last.
std::size_t branchBefore(const WaveSheet* sheets, std::size_t count, std::size_t behind)
{
  std::size_t before = count;
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool fits = sheets[i].caustics + 1 == sheets[behind].caustics &&
      sheets[i].reflections == sheets[behind].reflections && sheets[i].phase < sheets[behind].phase;
    before = fits && (before == count || sheets[i].phase > sheets[before].phase) ? i : before;
  }
  return before;
}

// Geometric height of a branch, from its own modulus where the sheet is too coarse for a tube that closes.
double branchOf(const WaveSheet& sheet, double half)
{
  const double own = sheet.height / foldModulus(half);
  return sheet.branch < LargestBranch * own ? sheet.branch : own;
}

// Both branches as one wave. Their heights are the same on the caustic: what the sheets say of their difference there would
// grow without limit.
std::complex<double> joinedBranches(FoldBranch before, FoldBranch behind)
{
  const double sum = before.amplitude + behind.amplitude;
  const double half = std::max(0.0, 0.5 * (behind.phase - before.phase));
  const double most = sum * std::min(1.0, LargestDifference * std::cbrt(1.5 * half));
  const double difference = std::clamp(before.amplitude - behind.amplitude, -most, most);
  before.amplitude = 0.5 * (sum + difference);
  behind.amplitude = 0.5 * (sum - difference);
  return foldWave(before, behind);
}

// Interference of all sheets, the two branches of each fold together, and of the strips that take their place.
std::complex<double> interfere(
  const WaveSheet* sheets, std::size_t count, const FoldShare* folds, std::size_t foldCount)
{
  std::complex<double> sum = 0.0;
  std::vector<double> weight(count, 1.0);
  for (const FoldShare* fold = folds; fold != folds + foldCount; ++fold)
  {
    sum += fold->weight * fold->wave;
    for (std::size_t i = 0; i < count; ++i)
    {
      const bool branch = sheets[i].reflections == fold->reflections &&
        (sheets[i].caustics == fold->number || sheets[i].caustics + 1 == fold->number);
      weight[i] *= branch && std::abs(sheets[i].phase - fold->middle) < fold->half + Ragged ? 1.0 - fold->hides : 1.0;
    }
  }
  // Amplitude of each sheet: of a branch, that of its nearest caustic; without another branch as high as its own modulus.
  std::vector<std::size_t> before(count);
  std::vector<double> half(count, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < count; ++i)
  {
    before[i] = branchBefore(sheets, count, i);
    if (before[i] < count)
    {
      const double between = 0.5 * (sheets[i].phase - sheets[before[i]].phase);
      half[i] = std::min(half[i], between);
      half[before[i]] = std::min(half[before[i]], between);
    }
  }
  std::vector<FoldBranch> branch(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    branch[i] = { std::isinf(half[i]) ? sheets[i].height : branchOf(sheets[i], half[i]), sheets[i].phase };
    sum += weight[i] * std::polar(branch[i].amplitude, branch[i].phase - 0.5 * Pi * sheets[i].caustics);
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    if (before[i] < count)
    {
      const FoldBranch& a = branch[before[i]];
      const std::complex<double> rays =
        std::polar(a.amplitude, a.phase) + std::polar(branch[i].amplitude, branch[i].phase - 0.5 * Pi);
      sum += std::min(weight[i], weight[before[i]]) * std::polar(1.0, -0.5 * Pi * sheets[before[i]].caustics) *
        (joinedBranches(a, branch[i]) - rays);
    }
  }
  return sum;
}

// Hits of a place stay in the order of the triangles, so that sums are the same for any number of threads.
void combineHits(Hits& hits, CombineRule rule, RayMap& map)
{
  const auto byPlace = [](const auto& a, const auto& b) { return a.place < b.place; };
  std::stable_sort(hits.sheets.begin(), hits.sheets.end(), byPlace);
  std::stable_sort(hits.folds.begin(), hits.folds.end(), byPlace);
  std::vector<WaveSheet> waves;
  std::vector<FoldShare> folds;
  auto hit = hits.sheets.begin();
  auto fold = hits.folds.begin();
  auto beam = hits.beams.begin();
  const auto next = [](auto at, auto end) { return at == end ? std::numeric_limits<std::size_t>::max() : at->place; };
  while (hit != hits.sheets.end() || fold != hits.folds.end() || beam != hits.beams.end())
  {
    const std::size_t place =
      std::min({ next(hit, hits.sheets.end()), next(fold, hits.folds.end()), next(beam, hits.beams.end()) });
    waves.clear();
    folds.clear();
    for (; hit != hits.sheets.end() && hit->place == place; ++hit)
    {
      waves.push_back(hit->wave);
    }
    for (; fold != hits.folds.end() && fold->place == place; ++fold)
    {
      folds.push_back(fold->wave);
    }
    const BeamShare* beams = next(beam, hits.beams.end()) == place ? &(beam++)->wave : nullptr;
    const CombinedWave wave = combineSheets(waves.data(), waves.size(), rule, folds.data(), folds.size(), beams);
    map.height[place] = wave.height;
    map.directionFrom[place] = wave.directionFrom;
    map.wavelength[place] = wave.wavelength;
    map.breaking[place] = wave.breaking ? 1 : 0;
    map.lee[place] = wave.lee ? 1 : 0;
    map.count[place] = wave.count;
  }
}

// The waves of beams at places of a row.
class BeamRow
{
public:
  explicit BeamRow(const GaussianBeams* beams)
    : Beams(beams && !beams->empty() ? beams : nullptr)
  {
  }

  /** @param firstPlace index of the first of them; `depth` as for mapRays */
  void look(const glm::dvec2& first, double spacing, std::size_t count, const double* depth, std::size_t firstPlace,
    std::vector<BeamHit>& hits)
  {
    if (!this->Beams)
    {
      return;
    }
    this->Shares.assign(count, {});
    bool any = false;
    for (std::size_t i = 0; i < count; ++i)
    {
      const bool wet = !depth || depth[firstPlace + i] > 0.0;
      this->Shares[i].weight = wet ? this->Beams->reach({ first.x + spacing * static_cast<double>(i), first.y }) : 0.0;
      any = any || this->Shares[i].weight > 0.0;
    }
    if (any)
    {
      this->Beams->addRow(first, spacing, count, this->Shares.data());
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      if (this->Shares[i].weight > 0.0)
      {
        hits.push_back({ firstPlace + i, this->Shares[i] });
      }
    }
  }

private:
  const GaussianBeams* Beams;
  std::vector<BeamShare> Shares;
};

// Energies of sheets need neither strips nor beams: their heights are finite.
template <typename T>
std::optional<T> makeFor(const RaySheets& sheets, CombineRule rule, const Execution& execution)
{
  return rule == CombineRule::Phase ? std::optional<T>(std::in_place, sheets, execution) : std::nullopt;
}

void validate(const MapGrid& grid)
{
  if (grid.columns == 0 || grid.rows == 0 || !(grid.spacing.x > 0.0) || !(grid.spacing.y > 0.0))
  {
    std::ostringstream message;
    message << "a map of " << grid.columns << " x " << grid.rows << " nodes " << grid.spacing.x << " and "
            << grid.spacing.y << " m apart cannot be made; it needs nodes, and distances above 0";
    throw std::invalid_argument(message.str());
  }
}

}

CombinedWave combineSheets(const WaveSheet* sheets, std::size_t count, CombineRule rule, const FoldShare* folds,
  std::size_t foldCount, const BeamShare* beams)
{
  CombinedWave combined;
  combined.count = static_cast<std::int32_t>(count);
  const bool strips = rule == CombineRule::Phase && foldCount > 0;
  const bool withBeams = rule == CombineRule::Phase && beams && beams->weight > 0.0;
  const auto wave = [&]()
  {
    const double rest = withBeams ? 1.0 - beams->weight : 1.0;
    const std::complex<double> sum = interfere(sheets, count, folds, strips ? foldCount : 0);
    return withBeams ? rest * sum + beams->weight * beams->wave : sum;
  };
  if (count == 0)
  {
    const glm::dvec2 wavenumber = strips ? folds->wavenumber : withBeams ? beams->wavenumber : glm::dvec2(NotANumber);
    combined.height = strips || withBeams ? std::abs(wave()) : NotANumber;
    combined.directionFrom = strips || withBeams ? nauticalFromVector(wavenumber) : NotANumber;
    combined.wavelength = strips || withBeams ? 2.0 * Pi / glm::length(wavenumber) : NotANumber;
    return combined;
  }
  const WaveSheet* highest = std::max_element(
    sheets, sheets + count, [](const WaveSheet& a, const WaveSheet& b) { return a.height < b.height; });
  combined.breaking = highest->broken;
  combined.lee = highest->lee;
  combined.directionFrom = nauticalFromVector(highest->wavenumber);
  combined.wavelength = 2.0 * Pi / glm::length(highest->wavenumber);
  combined.height = highest->height;
  // One wave needs no mean, and next to an infinite or no wave at all no other counts.
  if ((count == 1 && !strips && !withBeams) || !(highest->height > 0.0) || std::isinf(highest->height))
  {
    return combined;
  }

  double energy = 0.0;
  double wavenumber = 0.0;
  glm::dvec2 direction(0.0);
  for (const WaveSheet* sheet = sheets; sheet != sheets + count; ++sheet)
  {
    const double squared = sheet->height * sheet->height;
    const double k = glm::length(sheet->wavenumber);
    energy += squared;
    wavenumber += squared * k;
    direction += squared * sheet->wavenumber / k;
  }
  combined.height = rule == CombineRule::Energy ? std::sqrt(energy) : std::abs(wave());
  combined.wavelength = 2.0 * Pi * energy / wavenumber;
  if (glm::length(direction) > NoMean * energy)
  {
    combined.directionFrom = nauticalFromVector(direction);
  }
  return combined;
}

RayMap mapRays(
  const RaySheets& sheets, const MapGrid& grid, const double* depth, CombineRule rule, const Execution& execution)
{
  validate(grid);
  RayMap map;
  resize(map, grid.columns * grid.rows);
  const std::vector<RaySheets::Triangle>& triangles = sheets.triangles();
  const std::size_t bands = (grid.rows + RowsAtOnce - 1) / RowsAtOnce;
  const double bandHeight = grid.spacing.y * static_cast<double>(RowsAtOnce);
  const Bins bins = sortIntoBins(bands, triangles.size(),
    [&](std::size_t i)
    {
      const Rectangle box = sheets.box(triangles[i]);
      // The node above a band's last one belongs to the next band.
      return spanOf(box.low.y - grid.spacing.y, box.high.y, grid.origin.y, bandHeight, bands);
    });

  const std::optional<FoldStrips> folds = makeFor<FoldStrips>(sheets, rule, execution);
  const std::optional<GaussianBeams> beams = makeFor<GaussianBeams>(sheets, rule, execution);
  const Bins foldBins = sortIntoBins(bands, folds ? folds->size() : 0,
    [&](std::size_t i)
    {
      const Rectangle box = folds->box(i);
      return spanOf(box.low.y - grid.spacing.y, box.high.y, grid.origin.y, bandHeight, bands);
    });
  execution.forRange(bands,
    [&](std::size_t begin, std::size_t end)
    {
      Hits hits;
      BeamRow beamRow(beams ? &*beams : nullptr);
      SheetHit hit;
      FoldHit foldHit;
      // Every node of a band in a box.
      const auto visit = [&](std::size_t band, const Rectangle& box, const auto& look)
      {
        const Span columns = spanOf(box.low.x, box.high.x, grid.origin.x, grid.spacing.x, grid.columns);
        const Span rows = spanOf(box.low.y, box.high.y, grid.origin.y, grid.spacing.y, grid.rows);
        const std::size_t lastRow = std::min({ rows.last, grid.rows, (band + 1) * RowsAtOnce });
        for (std::size_t row = std::max(rows.first, band * RowsAtOnce); row < lastRow; ++row)
        {
          for (std::size_t column = columns.first; column < columns.last; ++column)
          {
            const std::size_t place = row * grid.columns + column;
            if (!depth || depth[place] > 0.0)
            {
              look(
                place, grid.origin + grid.spacing * glm::dvec2(static_cast<double>(column), static_cast<double>(row)));
            }
          }
        }
      };
      for (std::size_t band = begin; band < end; ++band)
      {
        hits.clear();
        for (std::size_t at = bins.offsets[band]; at < bins.offsets[band + 1]; ++at)
        {
          const RaySheets::Triangle& triangle = triangles[bins.items[at]];
          visit(band, sheets.box(triangle),
            [&](std::size_t place, const glm::dvec2& node)
            {
              hit.place = place;
              if (sheets.wave(triangle, sheets.inwards(node), hit.wave))
              {
                hits.sheets.push_back(hit);
              }
            });
        }
        for (std::size_t at = foldBins.offsets[band]; at < foldBins.offsets[band + 1]; ++at)
        {
          const std::size_t strip = foldBins.items[at];
          visit(band, folds->box(strip),
            [&](std::size_t place, const glm::dvec2& node)
            {
              foldHit.place = place;
              if (folds->wave(strip, node, foldHit.wave))
              {
                hits.folds.push_back(foldHit);
              }
            });
        }
        for (std::size_t row = band * RowsAtOnce; row < std::min(grid.rows, (band + 1) * RowsAtOnce); ++row)
        {
          beamRow.look(grid.origin + grid.spacing * glm::dvec2(0.0, static_cast<double>(row)), grid.spacing.x,
            grid.columns, depth, row * grid.columns, hits.beams);
        }
        combineHits(hits, rule, map);
      }
    });
  return map;
}

RayMap sampleRays(const RaySheets& sheets, const std::vector<glm::dvec2>& places, const double* depth, CombineRule rule,
  const Execution& execution)
{
  RayMap map;
  resize(map, places.size());
  std::vector<char> wanted(places.size(), 1);
  for (std::size_t i = 0; depth && i < places.size(); ++i)
  {
    wanted[i] = depth[i] > 0.0 ? 1 : 0;
  }
  Hits hits;
  hits.sheets = findSheets(sheets, places, &wanted, execution);
  if (const std::optional<FoldStrips> folds = makeFor<FoldStrips>(sheets, rule, execution))
  {
    FoldHit hit;
    for (hit.place = 0; hit.place < places.size(); ++hit.place)
    {
      for (std::size_t strip = 0; wanted[hit.place] != 0 && strip < folds->size(); ++strip)
      {
        if (folds->wave(strip, places[hit.place], hit.wave))
        {
          hits.folds.push_back(hit);
        }
      }
    }
  }
  if (const std::optional<GaussianBeams> beams = makeFor<GaussianBeams>(sheets, rule, execution))
  {
    BeamRow row(&*beams);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      row.look(places[i], 1.0, 1, depth, i, hits.beams);
    }
  }
  combineHits(hits, rule, map);
  return map;
}

}
