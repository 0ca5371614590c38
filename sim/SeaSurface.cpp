#include "sim/SeaSurface.h"

#include "sim/Angles.h"
#include "sim/Dispersion.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>

namespace swellray
{

namespace
{

// The matrix of wavenumbers reaches so far: what lies beyond is some percent of the energy, and turbulence.
constexpr double ReachOverPeakFrequency = 3.0;
constexpr std::size_t UsualSide = 64;
constexpr std::size_t LargestSide = 1024;

// Waves at the peak that a tile must hold at least.
constexpr double LeastWavesOfATile = 3.0;

// Of the peak, with some room: the spectrum reaches to nine times its wavenumber.
constexpr double MostWavesOfATile = 50.0;

// Points a side of a cell over which its energy is summed.
constexpr int PointsOfACell = 4;

}

struct SeaSurface::Cell
{
  glm::dvec2 wavenumber{ 0.0 };
  double energy = 0.0; // m2
  double frequency = 0.0;
};

void SeaSurfaceOptions::validate() const
{
  const auto require = [](bool good, const char* what)
  {
    if (!good)
    {
      throw std::invalid_argument(what);
    }
  };
  require(components >= 1 && components <= UsualSide * UsualSide, "the waves of a sea must be 1 to 4096");
  require(sharpness >= 0.0 && std::isfinite(sharpness), "the sharpness of waves must be 0 or above");
  require(!tile || (*tile > 0.0 && std::isfinite(*tile)), "the side of a tile must be above 0 m");
  require(depth > 0.0, "the depth of a sea must be above 0 m");
  require(gravity > 0.0 && std::isfinite(gravity), "gravity must be above 0 m/s2");
}

SeaSurface::~SeaSurface() = default;

double SeaSurface::wavenumberAt(double frequency) const
{
  return solveWavenumber(2.0 * Pi * frequency, this->Depth, this->Gravity);
}

double SeaSurface::frequencyAt(double wavenumber) const
{
  return std::sqrt(this->Gravity * wavenumber * std::tanh(std::min(wavenumber * this->Depth, 300.0))) / (2.0 * Pi);
}

std::vector<SeaSurface::Cell> SeaSurface::sampleCells(const FrequencySpectrum& spectrum,
  const DirectionalSpreading& spreading, double heading, const SeaSurfaceOptions& options) const
{
  const double peak = this->wavenumberAt(spectrum.peakFrequency());
  const double reach = this->wavenumberAt(ReachOverPeakFrequency * spectrum.peakFrequency());
  double width = 2.0 * reach / UsualSide;
  std::size_t side = UsualSide;
  if (options.tile)
  {
    width = 2.0 * Pi / *options.tile;
    const auto refuse = [&](const char* what, const char* bound, double waves)
    {
      const auto whole = [](double metres) { return std::to_string(static_cast<long long>(std::ceil(metres))); };
      throw std::invalid_argument("a tile of " + whole(*options.tile) + " m is too " + what + " for waves of " +
        whole(2.0 * Pi / peak) + " m; choose a size of " + bound + " " + whole(waves * 2.0 * Pi / peak) + " m");
    };
    if (peak < LeastWavesOfATile * width)
    {
      refuse("small", "at least", LeastWavesOfATile);
    }
    const double cells = 2.0 * std::ceil(reach / width);
    if (cells > static_cast<double>(LargestSide))
    {
      refuse("large", "at most", MostWavesOfATile);
    }
    side = static_cast<std::size_t>(cells);
  }
  std::mt19937_64 random(options.seed);
  const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<Cell> cells;
  for (std::size_t index = 0; index < side * side; ++index)
  {
    const auto column = static_cast<double>(index % side) - 0.5 * static_cast<double>(side);
    const auto row = static_cast<double>(index / side) - 0.5 * static_cast<double>(side);
    // The middles of a tile's cells are its wavenumbers; else wavenumbers lie anywhere, so that nothing repeats.
    const glm::dvec2 corner = width * (glm::dvec2(column, row) - (options.tile ? 0.5 : 0.0));
    const double part = width / PointsOfACell;
    std::array<double, PointsOfACell * PointsOfACell> energies{};
    const auto pointAt = [&](int i, const glm::dvec2& within)
    { return corner + part * (glm::dvec2(i % PointsOfACell, i / PointsOfACell) + within); };
    Cell cell;
    for (int i = 0; i < PointsOfACell * PointsOfACell; ++i)
    {
      const glm::dvec2 point = pointAt(i, glm::dvec2(0.5));
      const double k = glm::length(point);
      const double f = this->frequencyAt(k);
      // E(kx, ky) = E(f, direction) (df/dk)/k
      const double groupSpeed = waveSpeeds(k, this->Depth, this->Gravity).groupSpeed;
      energies[static_cast<std::size_t>(i)] = spectrum.density(f) *
        spreading.density(f, std::atan2(point.y, point.x) - heading) * groupSpeed / (2.0 * Pi * k) * part * part;
      cell.energy += energies[static_cast<std::size_t>(i)];
    }
    // The middles of a tile's cells are its wavenumbers; else they lie where the energy is, somewhere, so that nothing
    // repeats.
    double drawn = share() * cell.energy;
    int chosen = 0;
    while (chosen + 1 < PointsOfACell * PointsOfACell && drawn > energies[static_cast<std::size_t>(chosen)])
    {
      drawn -= energies[static_cast<std::size_t>(chosen++)];
    }
    const glm::dvec2 within(share(), share());
    cell.wavenumber = options.tile ? corner + 0.5 * width : pointAt(chosen, within);
    const double k = glm::length(cell.wavenumber);
    if (!(k > 0.0))
    {
      continue;
    }
    cell.frequency = this->frequencyAt(k);
    cells.push_back(cell);
  }
  return cells;
}

SeaSurface::SeaSurface(const FrequencySpectrum& spectrum, const DirectionalSpreading& spreading, double heading,
  const SeaSurfaceOptions& options)
  : Depth(options.depth)
  , Gravity(options.gravity)
  , PeakPeriod(spectrum.peakPeriod())
{
  options.validate();
  std::vector<Cell> cells = this->sampleCells(spectrum, spreading, heading, options);
  const std::size_t count = std::min(options.components, cells.size());
  std::stable_sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.energy > b.energy; });
  for (std::size_t i = 0; i < count; ++i)
  {
    this->HighestFrequency = std::max(this->HighestFrequency, cells[i].frequency);
  }
  const double m0 = spectrum.moment(0);
  const auto overWavenumber = [&](double k) {
    return spectrum.density(this->frequencyAt(k)) * waveSpeeds(k, this->Depth, this->Gravity).groupSpeed / (2.0 * Pi);
  };
  const double highest = this->wavenumberAt(this->HighestFrequency);
  if (options.turbulence)
  {
    constexpr double Off = 0.05;
    TurbulenceTarget target;
    target.wavenumber = highest;
    target.level = overWavenumber(highest);
    target.slope = std::log(overWavenumber(highest * (1.0 + Off)) / overWavenumber(highest * (1.0 - Off))) /
      std::log((1.0 + Off) / (1.0 - Off));
    target.heading = heading;
    target.gravity = this->Gravity;
    target.depth = this->Depth;
    target.tile = options.tile;
    target.seed = options.seed;
    this->Turbulence = std::make_unique<SeaTurbulence>(target);
  }

  // Energy of the cells below fmax, less that of the turbulence, to the nearest of those chosen.
  std::vector<double> energies(count, 0.0);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const Cell& cell = cells[i];
    if (cell.frequency > this->HighestFrequency)
    {
      continue;
    }
    const double k = glm::length(cell.wavenumber);
    const double noise = this->Turbulence ? this->Turbulence->density(k) : 0.0;
    const double left = std::max(0.0, 1.0 - noise / std::max(overWavenumber(k), 1e-300));
    std::size_t nearest = i;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < count && i >= count; ++j)
    {
      const glm::dvec2 apart = cells[j].wavenumber - cell.wavenumber;
      const double square = glm::dot(apart, apart);
      nearest = square < distance ? j : nearest;
      distance = std::min(square, distance);
    }
    energies[nearest] += left * cell.energy;
  }
  const double drawn = std::accumulate(energies.begin(), energies.end(), 0.0);
  const double noise = this->Turbulence ? this->Turbulence->variance() : 0.0;
  const double scale = drawn > 0.0 ? std::max(0.0, m0 - noise) / drawn : 0.0;
  std::mt19937_64 random(options.seed + 0x9e3779b97f4a7c15ULL);
  double slopes = this->Turbulence ? noise * highest * highest : 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    SeaComponent component;
    component.amplitude = std::sqrt(2.0 * scale * energies[i]);
    component.wavenumber = cells[i].wavenumber;
    component.frequency = 2.0 * Pi * cells[i].frequency;
    component.phase = 2.0 * Pi * static_cast<double>(random() >> 11) * 0x1p-53;
    const double k = glm::length(component.wavenumber);
    component.wavelength = 2.0 * Pi / k;
    component.steepness = std::min(1.0, options.sharpness * k * component.amplitude);
    slopes += k * k * scale * energies[i];
    this->Components.push_back(component);
  }
  this->MeanSquare = scale * drawn + noise;
  this->Slope = std::sqrt(slopes);
}

double SeaSurface::height(const glm::dvec2& place, double time, double footprint) const
{
  double sum = this->Turbulence ? this->Turbulence->height(place, time, footprint) : 0.0;
  for (const SeaComponent& wave : this->Components)
  {
    const double weight = footprint > 0.0 ? footprintWeight(2.0 * Pi / glm::length(wave.wavenumber), footprint) : 1.0;
    if (weight > 0.0)
    {
      const double phase = glm::dot(wave.wavenumber, place) - wave.frequency * time + wave.phase;
      sum += weight * wave.amplitude * this->Profile.value(phase, wave.steepness);
    }
  }
  return sum;
}

glm::dvec3 SeaSurface::normal(const glm::dvec2& place, double time, double footprint) const
{
  constexpr double Least = 0.01;
  const double off = std::max(0.5 * footprint, Least);
  const double x = this->height(place + glm::dvec2(off, 0.0), time, footprint) -
    this->height(place - glm::dvec2(off, 0.0), time, footprint);
  const double y = this->height(place + glm::dvec2(0.0, off), time, footprint) -
    this->height(place - glm::dvec2(0.0, off), time, footprint);
  return glm::normalize(glm::dvec3(-x, -y, 2.0 * off));
}

std::optional<double> SeaSurface::march(
  const glm::dvec3& origin, const glm::dvec3& direction, double time, double farthest, double pixel) const
{
  // Heights and slopes are nearly Gaussian: five and four standard deviations are passed by next to none.
  const double top = 5.0 * std::sqrt(this->MeanSquare);
  const double steepest = 4.0 * this->Slope;
  double near = 0.0;
  double far = farthest;
  if (direction.z != 0.0)
  {
    const double a = (top - origin.z) / direction.z;
    const double b = (-top - origin.z) / direction.z;
    near = std::max(near, std::min(a, b));
    far = std::min(far, std::max(a, b));
  }
  else if (std::abs(origin.z) > top)
  {
    return {};
  }
  const auto above = [&](double s)
  {
    const glm::dvec3 p = origin + s * direction;
    return p.z - this->height({ p.x, p.y }, time, s * pixel);
  };
  const double closing = std::max(-direction.z + steepest * std::hypot(direction.x, direction.y), 1e-3);
  double before = near;
  for (double s = near; s <= far;)
  {
    const double gap = above(s);
    if (gap <= 0.0)
    {
      // By the secant through both sides, the weight of one that stays being halved (Illinois).
      double low = before;
      double high = s;
      double lowGap = s > near ? above(low) : 0.0;
      double highGap = gap;
      int stays = 0;
      constexpr int Most = 40;
      for (int i = 0; i < Most && lowGap > 0.0 && high - low > 1e-3 * std::max(s * pixel, 1e-3); ++i)
      {
        const double middle = low + (high - low) * lowGap / (lowGap - highGap);
        const double here = above(middle);
        const bool isLow = here > 0.0;
        (isLow ? low : high) = middle;
        (isLow ? lowGap : highGap) = here;
        (isLow ? highGap : lowGap) *= stays == (isLow ? 1 : -1) ? 0.5 : 1.0;
        stays = isLow ? 1 : -1;
      }
      return high;
    }
    before = s;
    constexpr double LeastStep = 1e-3; // m, and of a footprint
    s += std::max({ gap / closing, LeastStep, 0.1 * s * pixel });
  }
  return {};
}

void sampleSea(const SeaSurface& surface, const glm::dvec2& corner, double spacing, std::size_t columns,
  std::size_t rows, double time, double* heights, float* normals, const Execution& execution)
{
  // One point more on each side, for the differences.
  const std::size_t width = columns + 2;
  const std::size_t lines = rows + 2;
  std::vector<double> wide(width * lines);
  constexpr std::size_t Batches = 20; // between which progress is told
  for (std::size_t batch = 0; batch < Batches; ++batch)
  {
    const std::size_t first = lines * batch / Batches;
    execution.forRange(lines * (batch + 1) / Batches - first,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = (first + begin) * width; i < (first + end) * width; ++i)
        {
          const glm::dvec2 step(static_cast<double>(i % width) - 1.0, static_cast<double>(i / width) - 1.0);
          wide[i] = surface.height(corner + spacing * step, time, spacing);
        }
      });
    if (!execution.report(static_cast<double>(batch + 1) / Batches))
    {
      return;
    }
  }
  for (std::size_t row = 0; row < rows; ++row)
  {
    for (std::size_t column = 0; column < columns; ++column)
    {
      const double* here = wide.data() + (row + 1) * width + column + 1;
      const std::size_t i = row * columns + column;
      heights[i] = *here;
      if (normals)
      {
        const glm::dvec3 normal =
          glm::normalize(glm::dvec3(*(here - 1) - *(here + 1), *(here - width) - *(here + width), 2.0 * spacing));
        for (int c = 0; c < 3; ++c)
        {
          normals[3 * i + static_cast<std::size_t>(c)] = static_cast<float>(normal[c]);
        }
      }
    }
  }
}

}
