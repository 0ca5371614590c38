// Rays on currents against tables of reference solutions, where these lie beside the data folder.
#include "Currents.h"

#include "sim/BuiltinCurrent.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace swellray;
using namespace swellray::testing;

namespace
{

constexpr double Tolerance = 1e-12;

const Rectangle Scene{ { -4000.0, -40000.0 }, { 4000.0, 40000.0 } };

std::vector<std::vector<double>> load(const std::string& name)
{
  const char* data = std::getenv("SWELLRAY_DATA");
  std::ifstream in(std::filesystem::path(data ? data : SWELLRAY_DATA_DEFAULT).parent_path() / "reference" / name);
  std::vector<std::vector<double>> rows;
  std::string line;
  bool named = false;
  while (std::getline(in, line))
  {
    if (line.empty() || line[0] == '#')
    {
      continue;
    }
    if (!named)
    {
      named = true;
      continue;
    }
    std::stringstream cells(line);
    std::string cell;
    rows.emplace_back();
    while (std::getline(cells, cell, ','))
    {
      rows.back().push_back(std::strtod(cell.c_str(), nullptr));
    }
  }
  return rows;
}

}

#define LOAD_OR_SKIP(rows, name)                                                                                       \
  const std::vector<std::vector<double>> rows = load(name);                                                            \
  if (rows.empty())                                                                                                    \
  {                                                                                                                    \
    GTEST_SKIP() << "no reference table " << name;                                                                     \
  }

TEST(ReferenceCurrents, collinear)
{
  LOAD_OR_SKIP(rows, "c8_collinear.csv");
  // The table is exact to 1e-14; a ray at tolerance 1e-12 keeps 1e-9, less near the block, where k answers to U as the
  // inverse root of what is left: its first row lies at 0.9996 of the blocking current.
  constexpr double Relative = 1e-7;
  for (const std::vector<double>& row : rows)
  {
    const double u = row[0];
    const CollinearCurrent current(0.0, u, 0.0, 200.0);
    const FlatBed bed(Scene, DeepBed);
    const RayMedium medium = mediumWith(bed, current, 10.0);
    const double omega = medium.angularFrequency;
    RayStart start;
    start.position = { -3900.0, 0.0 };
    start.wavenumber = { omega * omega / StandardGravity, 0.0 };
    start.dPosition = { 0.0, 1.0 };
    HamiltonianRay ray(medium, start, Tolerance);
    RayPoint point;
    // Where the current is that of the row to the last bit.
    ASSERT_TRUE(ray.advance(FrontMeasure::Length, 7800.0, point)) << u;
    const WaveSpeeds speeds = waveSpeeds(glm::length(point.wavenumber), point.depth);
    EXPECT_NEAR(point.wavenumber.x / row[1], 1.0, Relative) << u;
    EXPECT_NEAR(point.wavenumber.x * speeds.phaseSpeed / row[3], 1.0, Relative) << u;
    EXPECT_NEAR((speeds.groupSpeed + u) / row[4], 1.0, 1e-5) << u;
    EXPECT_NEAR(amplification(point, medium, 0.5 * StandardGravity / omega) / row[5], 1.0, 1e-5) << u;
  }
}

TEST(ReferenceCurrents, jets)
{
  struct Jet
  {
    const char* name;
    const char* spec;
    double depth;
    double period;
  };
  for (const Jet& jet :
    { Jet{ "c8_jet_1.csv", "jet:V0=2,w=200", DeepBed, 10.0 }, Jet{ "c8_jet_2.csv", "jet:V0=-2.5,w=250", DeepBed, 10.0 },
      Jet{ "c8_jet_3.csv", "jet:V0=1.5,w=150", 12.0, 9.0 }, Jet{ "c8_jet_4.csv", "jet:V0=3,w=200", DeepBed, 10.0 } })
  {
    LOAD_OR_SKIP(rows, jet.name);
    const auto current = makeBuiltinCurrent(jet.spec);
    const FlatBed bed(Scene, jet.depth);
    const RayMedium medium = mediumWith(bed, *current, jet.period);
    RayStart start;
    start.position = { rows[0][0], rows[0][1] };
    start.wavenumber = { rows[0][3], rows[0][4] };
    start.dPosition = { 0.0, std::hypot(rows[0][7], rows[0][8]) / rows[0][7] };
    const double groupSpeed0 = std::hypot(rows[0][7], rows[0][8] - current->velocity(start.position).y);
    HamiltonianRay ray(medium, start, Tolerance);
    RayPoint point;
    for (const std::vector<double>& row : rows)
    {
      ASSERT_TRUE(ray.advance(FrontMeasure::Time, row[2], point)) << jet.name;
      // The table is good for 5e-9 m; a ray adds about as much a km.
      EXPECT_NEAR(point.position.x, row[0], 1e-6) << jet.name;
      EXPECT_NEAR(point.position.y, row[1], 1e-6) << jet.name;
      EXPECT_NEAR(point.wavenumber.x, row[3], 1e-10) << jet.name;
      EXPECT_NEAR(point.wavenumber.y, row[4], 1e-12) << jet.name;
      const double height = amplification(point, medium, groupSpeed0);
      // Heights are infinite where the ray turns, and errors grow towards it.
      if (std::isfinite(row[9]) && row[9] < 10.0)
      {
        EXPECT_NEAR(height / row[9], 1.0, 1e-7 * row[9] * row[9] * row[9] * row[9]) << jet.name << " " << row[0];
        EXPECT_EQ(point.caustics, static_cast<int>(row[10])) << jet.name << " " << row[0];
      }
    }
  }
}

TEST(ReferenceCurrents, eddy)
{
  LOAD_OR_SKIP(rows, "c8_eddy.csv");
  const auto current = makeBuiltinCurrent("eddy:U0=1.5,R=300");
  const FlatBed bed(Scene, DeepBed);
  const RayMedium medium = mediumWith(bed, *current, 10.0);
  std::unique_ptr<HamiltonianRay> ray;
  double b = std::numeric_limits<double>::quiet_NaN();
  for (const std::vector<double>& row : rows)
  {
    if (!(row[0] == b))
    {
      b = row[0];
      RayStart start;
      start.position = { row[2], row[3] };
      start.wavenumber = { row[4], row[5] };
      start.dPosition = { 0.0, 1.0 };
      ray = std::make_unique<HamiltonianRay>(medium, start, Tolerance);
    }
    RayPoint point;
    ASSERT_TRUE(ray->advance(FrontMeasure::Time, row[1], point));
    EXPECT_NEAR(point.position.x, row[2], 1e-6) << b; // the table: 1e-7 m
    EXPECT_NEAR(point.position.y, row[3], 1e-6) << b;
    EXPECT_NEAR(point.wavenumber.x, row[4], 1e-10) << b;
    EXPECT_NEAR(point.wavenumber.y, row[5], 1e-10) << b;
  }
}
