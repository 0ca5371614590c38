// The sea behind a shoal by backward rays, against forward rays of many components binned on a map.
//
// A forward ray stands for the power E0 df dtheta Cg0 dlambda of its tube (over rho g). In a steady sea a ray that stays for a
// time t in a cell of area A leaves power times t in it: m0 = sum (power t)/A. That knows neither the width of tubes nor caustics.
#include "sim/Angles.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/SpectralSea.h"
#include "sim/WaveTracer.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace swellray;

namespace
{

// Cells of 200 m are crossed by some n = 5 rays of a component, 40 m apart. The ends of a row of rays lie anywhere between two
// of them: 1/sqrt(6) ray of error a component and cell, and of 2 x 20 components that matter 1/(5 sqrt(6 x 40)) = 1.3 % of m0 (standard
// deviation), 0.65 % of Hs. Bins of 10 degrees in two parts are good to 1 % of Hs (TestSpectralTransfer). Three of the former and the
// latter, in the worst of the cells.
constexpr double HeightAgreement = 0.03;
// The same 1.3 % of the energy at the edge of a sea 15 degrees wide, three times; and 1 % of that width by the bins.
constexpr double DirectionAgreement = 1.0; // degrees

constexpr double Floor = 20.0;      // depth around the shoal, where the sea is given too, m
constexpr double Spread = 15.0;     // degrees
constexpr double Heading = 0.2;     // rad
constexpr double RaySpacing = 40.0; // m
constexpr double CellSide = 200.0;  // m
constexpr int Columns = 9;          // from the top of the shoal to its lee
constexpr int Rows = 8;
const glm::dvec2 Corner(-400.0, -800.0);

struct Binned
{
  double energy = 0.0; // m2
  glm::dvec2 flow{ 0.0 };
};

// What the rays of one component leave in the cells. `power`: of a metre of crest, m3/s.
void bin(const RayField& field, double power, std::vector<Binned>& cells)
{
  std::vector<std::size_t> order(field.rays.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto lambda = [&](std::size_t i) { return field.rays[i].launchParameter; };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return lambda(a) < lambda(b); });
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const double low = i == 0 ? lambda(order[0]) : lambda(order[i - 1]);
    const double high = i + 1 == order.size() ? lambda(order[i]) : lambda(order[i + 1]);
    const double width = 0.5 * (high - low);
    for (std::size_t p = field.offsets[order[i]]; p + 1 < field.offsets[order[i] + 1]; ++p)
    {
      const RayPoint& from = field.points[p];
      const RayPoint& to = field.points[p + 1];
      // In parts of a tenth of a cell, each counted where its middle lies.
      const int parts = 1 + static_cast<int>(glm::length(to.position - from.position) / (0.1 * CellSide));
      for (int part = 0; part < parts; ++part)
      {
        const double share = (part + 0.5) / parts;
        const glm::dvec2 at = (from.position + share * (to.position - from.position) - Corner) / CellSide;
        if (at.x < 0.0 || at.y < 0.0 || at.x >= Columns || at.y >= Rows)
        {
          continue;
        }
        Binned& cell = cells[static_cast<std::size_t>(at.y) * Columns + static_cast<std::size_t>(at.x)];
        const double energy = power * width * (to.travelTime - from.travelTime) / parts / (CellSide * CellSide);
        cell.energy += energy;
        cell.flow += energy * glm::normalize(from.wavenumber + share * (to.wavenumber - from.wavenumber));
      }
    }
  }
}

TEST(SeaByForwardRays, manyComponentsBinnedOnAMapAgree)
{
  const auto shoal = makeBuiltinSeafloor("shoal");
  SpectralSeaOptions options;
  options.rays.grid = SpectralGrid::logarithmic(0.08, 0.11, 2, 36);
  options.rays.perDirection = 2;
  // Components offshore: directions 2 degrees apart, all that have energy.
  SpectralGrid fine = options.rays.grid;
  fine.headings = SpectralGrid::logarithmic(0.1, 1.0, 2, 180).headings;
  DirectionalSpectrum sea;
  sea.grid = fine;
  const auto spreading = DirectionalSpreading::cosinePower(radians(Spread));
  for (std::size_t f = 0; f < fine.frequencies.size(); ++f)
  {
    for (const double heading : fine.headings)
    {
      sea.density.push_back(10.0 * spreading.density(fine.frequencies[f], std::remainder(heading - Heading, 2.0 * Pi)));
    }
  }

  const std::vector<double> df = fine.frequencyWeights();
  const std::vector<double> turns = fine.headingWeights();
  const double most = *std::max_element(sea.density.begin(), sea.density.end());
  std::vector<Binned> cells(static_cast<std::size_t>(Columns) * Rows);
  int components = 0;
  for (std::size_t f = 0; f < fine.frequencies.size(); ++f)
  {
    for (std::size_t j = 0; j < fine.headings.size(); ++j)
    {
      if (sea.at(f, j) < 1e-4 * most)
      {
        continue;
      }
      IncidentWave wave;
      wave.period = 1.0 / fine.frequencies[f];
      wave.directionFrom = nauticalFromVector({ std::cos(fine.headings[j]), std::sin(fine.headings[j]) });
      wave.offshoreDepth = Floor;
      TraceOptions tracing;
      tracing.spacing = RaySpacing;
      tracing.stepsPerWave = 1.5;
      tracing.tolerance = 1e-6;
      tracing.insertion = InsertionRule::None;
      tracing.leeRays = false;
      bin(traceWaves(*shoal, wave, tracing), sea.at(f, j) * df[f] * turns[j] * wave.groupSpeed(), cells);
      ++components;
    }
  }
  EXPECT_GT(components, 100);

  BackwardOptions backward;
  backward.offshoreDepth = Floor;
  const BackwardTracer tracer(*shoal, backward);
  constexpr int Side = 3; // places a side of a cell
  std::vector<glm::dvec2> places;
  for (int i = 0; i < Columns * Rows * Side * Side; ++i)
  {
    const int cell = i / (Side * Side);
    const glm::dvec2 within((i % Side + 0.5) / Side, (i / Side % Side + 0.5) / Side);
    places.push_back(Corner + CellSide * (glm::dvec2(cell % Columns, cell / Columns) + within));
  }
  std::vector<DirectionalSpectrum> spectra;
  transformSea(tracer, options, sea, places, {}, &spectra);

  const double open = seaParameters(sea).significantHeight;
  double least = open;
  double greatest = open;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    Binned there;
    for (int i = 0; i < Side * Side; ++i)
    {
      const DirectionalSpectrum& spectrum = spectra[c * Side * Side + static_cast<std::size_t>(i)];
      const std::vector<double> widths = spectrum.grid.headingWeights();
      for (std::size_t f = 0; f < df.size(); ++f)
      {
        for (std::size_t j = 0; j < widths.size(); ++j)
        {
          const double energy = spectrum.at(f, j) * df[f] * widths[j] / (Side * Side);
          there.energy += energy;
          there.flow += energy * glm::dvec2(std::cos(spectrum.grid.headings[j]), std::sin(spectrum.grid.headings[j]));
        }
      }
    }
    const double height = 4.0 * std::sqrt(there.energy);
    EXPECT_NEAR(4.0 * std::sqrt(cells[c].energy) / height, 1.0, HeightAgreement) << "cell " << c;
    EXPECT_NEAR(degrees(std::remainder(
                  std::atan2(cells[c].flow.y, cells[c].flow.x) - std::atan2(there.flow.y, there.flow.x), 2.0 * Pi)),
      0.0, DirectionAgreement)
      << "cell " << c;
    least = std::min(least, height);
    greatest = std::max(greatest, height);
  }
  // The shoal matters: what is compared is no open sea.
  EXPECT_LT(least, 0.9 * open);
  EXPECT_GT(greatest, 1.2 * open);
}

}
