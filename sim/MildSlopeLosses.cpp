#include "sim/MildSlopeLosses.h"

#include "sim/AmplitudeDispersion.h"
#include "sim/Breaking.h"
#include "sim/Dispersion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swellray
{

namespace
{

// Of random waves a place is marked as breaking where more than this share of them is broken.
constexpr double BrokenShare = 0.05;

// Of waves that are saturated, where they are as high as their limit but for this.
constexpr double Saturation = 0.98;

// Share of the way that the dispersion goes.
constexpr double Relaxation = 0.5;

// Rounds of four sweeps, and the largest change of ln E of one update.
constexpr int Rounds = 2;
constexpr double LargestChange = 3.0;

// Direction of the wave in an element, times the wavenumber.
glm::dvec2 headingIn(
  const MildSlopeMesh& mesh, const std::vector<std::complex<double>>& eta, std::size_t i, std::size_t j)
{
  const std::complex<double> a = eta[mesh.node(i, j)];
  const std::complex<double> b = eta[mesh.node(i + 1, j)];
  const std::complex<double> c = eta[mesh.node(i, j + 1)];
  const std::complex<double> d = eta[mesh.node(i + 1, j + 1)];
  return { std::arg((b + d) * std::conj(a + c)) / mesh.spacing().x,
    std::arg((c + d) * std::conj(a + b)) / mesh.spacing().y };
}

/**
 * Height of the progressive wave that has the energy of the element, H^2/4 = (|eta|^2 + |grad eta|^2/k^2)/2: a standing wave's |eta| alone
 * would make losses in stripes of half a wavelength, which reflect, which makes it more of a standing wave.
 */
double heightIn(const MildSlopeMesh& mesh, const std::vector<std::complex<double>>& eta, std::size_t i, std::size_t j)
{
  const std::complex<double> a = eta[mesh.node(i, j)];
  const std::complex<double> b = eta[mesh.node(i + 1, j)];
  const std::complex<double> c = eta[mesh.node(i, j + 1)];
  const std::complex<double> d = eta[mesh.node(i + 1, j + 1)];
  const double k = mesh.medium(i, j).wavenumber();
  // Differences over an element fall short of the slope of a wave by this.
  const auto slopeOf = [k](const std::complex<double>& difference, double spacing)
  {
    const double half = 0.5 * k * spacing;
    return std::norm(difference) * half * half / std::pow(spacing * std::sin(half), 2);
  };
  const double slope =
    slopeOf(0.5 * (b + d - a - c), mesh.spacing().x) + slopeOf(0.5 * (c + d - a - b), mesh.spacing().y);
  const double square = 0.25 * (std::norm(a) + std::norm(b) + std::norm(c) + std::norm(d));
  return std::sqrt(2.0 * (square + slope / (k * k)));
}

// Root of a function that grows, within low and high: false position, the end that stays weighted down.
template <typename Function>
double rootOf(const Function& f, double low, double high)
{
  double fLow = f(low);
  double fHigh = f(high);
  if (fLow >= 0.0 || fHigh <= 0.0)
  {
    return fLow >= 0.0 ? low : high;
  }
  for (int i = 0; i < 60 && high - low > 1e-6; ++i)
  {
    const double middle = i % 3 == 2 ? 0.5 * (low + high) : (low * fHigh - high * fLow) / (fHigh - fLow);
    const double value = f(middle);
    (value < 0.0 ? low : high) = middle;
    (value < 0.0 ? fLow : fHigh) = value;
  }
  return 0.5 * (low + high);
}

}

MildSlopeFeedback::MildSlopeFeedback(const IncidentWave& wave, const MildSlopeOptions& options)
  : Wave(wave)
  , Options(options.height)
  , Gamma(breakerIndex(options.height, wave))
  , Losses(options.height.breaking != BreakingRule::None || options.height.friction > 0.0)
  , Dispersion(options.dispersion == WaveDispersion::Nonlinear)
{
}

double MildSlopeFeedback::limit(const MildSlopeMesh::Medium& medium, double slope) const
{
  switch (this->Options.breaking)
  {
  case BreakingRule::None:
    return std::numeric_limits<double>::infinity();
  case BreakingRule::Weggel:
    return weggelHeight(medium.depth, slope, this->Wave.period, this->Wave.gravity);
  case BreakingRule::Miche:
    return micheHeight(medium.linearWavenumber(), medium.depth);
  case BreakingRule::BattjesJanssen:
    return randomWaveLimit(medium.linearWavenumber(), medium.depth, this->Gamma);
  case BreakingRule::Baldock:
    return randomWaveLimit(medium.linearWavenumber(), medium.depth,
      this->Options.gamma.value_or(ruessinkGamma(medium.linearWavenumber(), medium.depth)));
  default:
    return this->Gamma * medium.depth;
  }
}

double MildSlopeFeedback::cap(const MildSlopeMesh::Medium& medium, double height) const
{
  const BreakingRule rule = this->Options.breaking;
  const bool saturated = rule == BreakingRule::Gamma || rule == BreakingRule::Miche;
  return saturated ? std::min(height, this->limit(medium, 0.0)) : height;
}

double MildSlopeFeedback::slopeAt(const MildSlopeMesh& mesh, std::size_t i, std::size_t j) const
{
  const auto change = [](double low, double high, double way) { return (high - low) / way; };
  const std::size_t west = i > 0 ? i - 1 : i;
  const std::size_t east = std::min(i + 1, mesh.sceneColumns() - 1);
  const std::size_t south = j > 0 ? j - 1 : j;
  const std::size_t north = std::min(j + 1, mesh.sceneRows() - 1);
  const double x =
    change(mesh.medium(west, j).depth, mesh.medium(east, j).depth, mesh.spacing().x * static_cast<double>(east - west));
  const double y = change(
    mesh.medium(i, south).depth, mesh.medium(i, north).depth, mesh.spacing().y * static_cast<double>(north - south));
  return std::hypot(x, y);
}

double MildSlopeFeedback::laminarLoss(const MildSlopeMesh::Medium& medium) const
{
  return this->Options.viscosity > 0.0 ? laminarFrictionRate(this->Options.viscosity, medium.linearWavenumber(),
                                           medium.depth, this->Wave.period, this->Wave.gravity)
                                       : 0.0;
}

void MildSlopeFeedback::begin(MildSlopeMesh& mesh) const
{
  for (std::size_t j = 0; j < mesh.sceneRows(); ++j)
  {
    for (std::size_t i = 0; i < mesh.sceneColumns(); ++i)
    {
      MildSlopeMesh::Medium& medium = mesh.medium(i, j);
      if (medium.kind == MildSlopeMesh::Kind::Water)
      {
        medium.loss = this->laminarLoss(medium);
      }
    }
  }
}

double MildSlopeFeedback::lossAt(
  const MildSlopeMesh::Medium& medium, double groupSpeed, double height, double highest, bool broken) const
{
  const double perDepth = groupSpeed / medium.depth;
  double loss = this->Options.friction > 0.0 ? frictionRate(this->Options.friction, height, medium.linearWavenumber(),
                                                 medium.depth, this->Wave.period, this->Wave.gravity)
                                             : this->laminarLoss(medium);
  if (this->Options.breaking == BreakingRule::BattjesJanssen)
  {
    loss += randomWaveLossRate(height / highest, this->Wave.period);
  }
  else if (this->Options.breaking == BreakingRule::Baldock)
  {
    loss += baldockLossRate(height / highest, height / medium.depth, this->Wave.period);
  }
  else if (broken)
  {
    const bool dally = this->Options.breaking == BreakingRule::Dally;
    const double stable = dally ? DallyStableIndex * medium.depth : highest;
    const double ratio = stable / height;
    loss += (dally ? DallyDecay : 1.0) * perDepth * std::max(0.0, 1.0 - ratio * ratio);
  }
  return loss;
}

void MildSlopeFeedback::findBroken(const MildSlopeMesh& mesh)
{
  const std::size_t columns = mesh.sceneColumns();
  const std::size_t rows = mesh.sceneRows();
  this->Broken.assign(columns * rows, 0);
  for (std::size_t j = 0; j < rows; ++j)
  {
    for (std::size_t i = 0; i < columns; ++i)
    {
      const MildSlopeMesh::Medium& medium = mesh.medium(i, j);
      const std::size_t e = j * columns + i;
      if (medium.kind != MildSlopeMesh::Kind::Water || this->Options.breaking == BreakingRule::None)
      {
        continue;
      }
      const double slope = this->Options.breaking == BreakingRule::Weggel ? this->slopeAt(mesh, i, j) : 0.0;
      const double ratio = this->Heights[e] / this->limit(medium, slope);
      const bool higher = this->Options.breaking == BreakingRule::Baldock;
      this->Broken[e] = ofRandomWaves(this->Options.breaking)
        ? (higher ? higherShare(ratio) : brokenShare(ratio)) > BrokenShare
        : ratio > Saturation;
    }
  }
}

void MildSlopeFeedback::setLosses(MildSlopeMesh& mesh, const std::vector<std::complex<double>>& eta)
{
  const std::size_t columns = mesh.sceneColumns();
  const std::size_t rows = mesh.sceneRows();
  struct Place
  {
    double alongX = 0.0; // |t.x| Cg/h, 1/s
    double alongY = 0.0;
    std::ptrdiff_t fromX = 0; // element up the wave, as a step
    std::ptrdiff_t fromY = 0;
    double groupSpeed = 0.0;
    double limit = 0.0;
    double loss = 0.0;
    bool water = false;
  };
  std::vector<Place> places(columns * rows);
  for (std::size_t j = 0; j < rows; ++j)
  {
    for (std::size_t i = 0; i < columns; ++i)
    {
      const MildSlopeMesh::Medium& medium = mesh.medium(i, j);
      Place& place = places[j * columns + i];
      const glm::dvec2 heading = headingIn(mesh, eta, i, j);
      const double size = std::hypot(heading.x, heading.y);
      place.water = medium.kind == MildSlopeMesh::Kind::Water && this->Heights[j * columns + i] > 0.0 && size > 0.0;
      if (!place.water)
      {
        continue;
      }
      const double slope = this->Options.breaking == BreakingRule::Weggel ? this->slopeAt(mesh, i, j) : 0.0;
      place.groupSpeed = waveSpeeds(medium.linearWavenumber(), medium.depth, this->Wave.gravity).groupSpeed;
      place.limit = this->limit(medium, slope);
      place.loss = medium.loss;
      place.alongX = std::abs(heading.x) / size * place.groupSpeed / mesh.spacing().x;
      place.alongY = std::abs(heading.y) / size * place.groupSpeed / mesh.spacing().y;
      place.fromX = heading.x > 0.0 ? -1 : 1;
      place.fromY = heading.y > 0.0 ? -1 : 1;
    }
  }

  std::vector<double> change(columns * rows, 0.0);
  const auto changeAt = [&](std::ptrdiff_t i, std::ptrdiff_t j)
  {
    const bool inside =
      i >= 0 && j >= 0 && i < static_cast<std::ptrdiff_t>(columns) && j < static_cast<std::ptrdiff_t>(rows);
    return inside ? change[static_cast<std::size_t>(j) * columns + static_cast<std::size_t>(i)] : 0.0;
  };
  // A wave of Dally's goes on breaking from where its height passes the limit on, until it is stable.
  const bool dally = this->Options.breaking == BreakingRule::Dally;
  if (dally)
  {
    this->Broken.assign(columns * rows, 0);
  }
  const auto brokenAt = [&](std::ptrdiff_t i, std::ptrdiff_t j)
  {
    const bool inside =
      i >= 0 && j >= 0 && i < static_cast<std::ptrdiff_t>(columns) && j < static_cast<std::ptrdiff_t>(rows);
    return inside && this->Broken[static_cast<std::size_t>(j) * columns + static_cast<std::size_t>(i)] ? 1.0 : 0.0;
  };
  const auto lossOf = [&](std::size_t e, double d)
  {
    const Place& place = places[e];
    const double height = this->Heights[e] * std::exp(0.5 * d);
    const bool broken = dally ? this->Broken[e] != 0 : height > place.limit;
    return this->lossAt(mesh.media()[e], place.groupSpeed, height, place.limit, broken);
  };
  for (int sweep = 0; sweep < 4 * Rounds; ++sweep)
  {
    for (std::size_t b = 0; b < rows; ++b)
    {
      const std::size_t j = sweep & 2 ? rows - 1 - b : b;
      for (std::size_t a = 0; a < columns; ++a)
      {
        const std::size_t i = sweep & 1 ? columns - 1 - a : a;
        const std::size_t e = j * columns + i;
        const Place& place = places[e];
        if (!place.water)
        {
          continue;
        }
        const auto x = static_cast<std::ptrdiff_t>(i);
        const auto y = static_cast<std::ptrdiff_t>(j);
        const double rate = place.alongX + place.alongY;
        const double before =
          (place.alongX * changeAt(x + place.fromX, y) + place.alongY * changeAt(x, y + place.fromY)) / rate;
        const auto excess = [&](double d) { return rate * (d - before) + lossOf(e, d) - place.loss; };
        if (dally)
        {
          this->Broken[e] = 0;
          const double free = std::min(before + (place.loss - lossOf(e, before)) / rate, LargestChange);
          const double height = this->Heights[e] * std::exp(0.5 * free);
          const double share =
            (place.alongX * brokenAt(x + place.fromX, y) + place.alongY * brokenAt(x, y + place.fromY)) / rate;
          this->Broken[e] =
            height > place.limit || (share > 0.5 && height > DallyStableIndex * mesh.media()[e].depth) ? 1 : 0;
        }
        // Where it loses what it did: nothing, or what does not depend on the height.
        const bool asBefore = lossOf(e, before) == place.loss;
        change[e] =
          asBefore ? std::clamp(before, -LargestChange, LargestChange) : rootOf(excess, -LargestChange, LargestChange);
      }
    }
  }
  for (std::size_t e = 0; e < places.size(); ++e)
  {
    if (places[e].water)
    {
      mesh.medium(e % columns, e / columns).loss = lossOf(e, change[e]);
    }
  }
}

double MildSlopeFeedback::update(MildSlopeMesh& mesh, const std::vector<std::complex<double>>& eta)
{
  const std::size_t columns = mesh.sceneColumns();
  std::vector<double> heights(mesh.media().size(), 0.0);
  double changed = 0.0;
  double whole = 0.0;
  this->Heights.resize(heights.size(), 0.0);
  for (std::size_t e = 0; e < heights.size(); ++e)
  {
    if (mesh.media()[e].kind != MildSlopeMesh::Kind::Water)
    {
      continue;
    }
    heights[e] = heightIn(mesh, eta, e % columns, e / columns);
    changed += (heights[e] - this->Heights[e]) * (heights[e] - this->Heights[e]);
    whole += heights[e] * heights[e];
  }
  this->Heights = std::move(heights);
  if (this->Options.breaking != BreakingRule::Dally)
  {
    this->findBroken(mesh);
  }

  if (this->Losses)
  {
    this->setLosses(mesh, eta);
  }
  const double relaxation = this->Started ? Relaxation : 1.0;
  for (std::size_t e = 0; e < this->Heights.size(); ++e)
  {
    MildSlopeMesh::Medium& medium = mesh.medium(e % columns, e / columns);
    if (medium.kind != MildSlopeMesh::Kind::Water)
    {
      continue;
    }
    const double height = this->Heights[e];
    if (this->Dispersion)
    {
      const double k =
        finiteAmplitudeWavenumber(this->Wave.angularFrequency(), medium.depth, 0.5 * height, this->Wave.gravity);
      const double linear = solveWavenumber(this->Wave.angularFrequency(), medium.depth, this->Wave.gravity);
      const double ratio = k / linear;
      medium.factor += relaxation * (ratio * ratio - medium.factor);
    }
  }
  const double change = this->Started && whole > 0.0 ? std::sqrt(changed / whole) : 1.0;
  this->Started = true;
  return change;
}

}
