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

constexpr double Relaxation = 0.5;

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

double MildSlopeFeedback::lossAt(
  const MildSlopeMesh::Medium& medium, double height, double highest, bool broken) const
{
  const double k = medium.linearWavenumber();
  const double perDepth = waveSpeeds(k, medium.depth, this->Wave.gravity).groupSpeed / medium.depth;
  double loss = this->Options.friction > 0.0
    ? frictionRate(this->Options.friction, height, k, medium.depth, this->Wave.period, this->Wave.gravity)
    : 0.0;
  if (this->Options.breaking == BreakingRule::BattjesJanssen)
  {
    loss += randomWaveLossRate(height / highest, this->Wave.period);
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

void MildSlopeFeedback::findBroken(const MildSlopeMesh& mesh, const std::vector<std::complex<double>>& eta)
{
  const std::size_t columns = mesh.sceneColumns();
  const std::size_t rows = mesh.sceneRows();
  this->Broken.assign(columns * rows, 0);
  std::vector<std::size_t> front;
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
      this->Broken[e] =
        this->Options.breaking == BreakingRule::BattjesJanssen ? brokenShare(ratio) > BrokenShare : ratio > 1.0;
      if (this->Broken[e])
      {
        front.push_back(e);
      }
    }
  }
  if (this->Options.breaking != BreakingRule::Dally)
  {
    return;
  }
  // A wave that broke goes on breaking, element by element down its way, until it is stable again.
  const auto headingOf = [&](std::size_t i, std::size_t j)
  {
    const std::complex<double> a = eta[mesh.node(i, j)];
    const std::complex<double> b = eta[mesh.node(i + 1, j)];
    const std::complex<double> c = eta[mesh.node(i, j + 1)];
    const std::complex<double> d = eta[mesh.node(i + 1, j + 1)];
    return glm::dvec2(std::arg((b + d) * std::conj(a + c)) / mesh.spacing().x,
      std::arg((c + d) * std::conj(a + b)) / mesh.spacing().y);
  };
  while (!front.empty())
  {
    const std::size_t e = front.back();
    front.pop_back();
    const std::size_t i = e % columns;
    const std::size_t j = e / columns;
    for (std::ptrdiff_t dy = -1; dy <= 1; ++dy)
    {
      for (std::ptrdiff_t dx = -1; dx <= 1; ++dx)
      {
        const std::ptrdiff_t ni = static_cast<std::ptrdiff_t>(i) + dx;
        const std::ptrdiff_t nj = static_cast<std::ptrdiff_t>(j) + dy;
        if (ni < 0 || nj < 0 || ni >= static_cast<std::ptrdiff_t>(columns) || nj >= static_cast<std::ptrdiff_t>(rows))
        {
          continue;
        }
        const auto next = static_cast<std::size_t>(nj) * columns + static_cast<std::size_t>(ni);
        const MildSlopeMesh::Medium& medium = mesh.media()[next];
        if (this->Broken[next] || medium.kind != MildSlopeMesh::Kind::Water ||
          this->Heights[next] <= DallyStableIndex * medium.depth)
        {
          continue;
        }
        const glm::dvec2 heading = headingOf(static_cast<std::size_t>(ni), static_cast<std::size_t>(nj));
        const double size = std::hypot(heading.x, heading.y);
        // The element that the wave comes from is this one.
        if (size > 0.0 && std::lround(heading.x / size) == dx && std::lround(heading.y / size) == dy)
        {
          this->Broken[next] = 1;
          front.push_back(next);
        }
      }
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
    const std::size_t i = e % columns;
    const std::size_t j = e / columns;
    const double square = std::norm(eta[mesh.node(i, j)]) + std::norm(eta[mesh.node(i + 1, j)]) +
      std::norm(eta[mesh.node(i, j + 1)]) + std::norm(eta[mesh.node(i + 1, j + 1)]);
    heights[e] = std::sqrt(square); // 2 times the root of the mean square
    changed += (heights[e] - this->Heights[e]) * (heights[e] - this->Heights[e]);
    whole += square;
  }
  this->Heights = std::move(heights);
  this->findBroken(mesh, eta);

  const double relaxation = this->Started ? Relaxation : 1.0;
  for (std::size_t e = 0; e < this->Heights.size(); ++e)
  {
    MildSlopeMesh::Medium& medium = mesh.medium(e % columns, e / columns);
    if (medium.kind != MildSlopeMesh::Kind::Water)
    {
      continue;
    }
    const double height = this->Heights[e];
    if (this->Losses && height > 0.0)
    {
      const double slope =
        this->Options.breaking == BreakingRule::Weggel ? this->slopeAt(mesh, e % columns, e / columns) : 0.0;
      const double wanted = this->lossAt(medium, height, this->limit(medium, slope), this->Broken[e] != 0);
      medium.loss += relaxation * (wanted - medium.loss);
    }
    if (this->Dispersion)
    {
      const double k = finiteAmplitudeWavenumber(
        this->Wave.angularFrequency(), medium.depth, 0.5 * height, this->Wave.gravity);
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
