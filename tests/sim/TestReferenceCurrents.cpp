// Rays on currents against tables of reference solutions, where these lie beside the data folder.
#include "Currents.h"
#include "ReferenceTable.h"

#include "sim/BuiltinCurrent.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>

using namespace swellray;
using namespace swellray::testing;

namespace
{

constexpr double Tolerance = 1e-12;

const Rectangle Scene{ { -4000.0, -40000.0 }, { 4000.0, 40000.0 } };

class ReferenceCurrents : public ::testing::Test
{
protected:
  void SetUp() override
  {
    if (!std::filesystem::is_directory(referenceFolder()))
    {
      GTEST_SKIP() << "no reference tables in " << referenceFolder();
    }
  }
};

}

TEST_F(ReferenceCurrents, collinear)
{
  const ReferenceTable table("c8_collinear");
  ASSERT_FALSE(table.empty());
  // The table is exact to 1e-14; a ray at tolerance 1e-12 keeps 1e-9, less near the block, where k answers to U as the
  // inverse root of what is left: its first row lies at 0.9996 of the blocking current.
  constexpr double Relative = 1e-7;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double u = table.at(row, "U");
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
    EXPECT_NEAR(point.wavenumber.x / table.at(row, "k"), 1.0, Relative) << u;
    EXPECT_NEAR(point.wavenumber.x * speeds.phaseSpeed / table.at(row, "sigma"), 1.0, Relative) << u;
    EXPECT_NEAR((speeds.groupSpeed + u) / table.at(row, "Cg_abs"), 1.0, 1e-5) << u;
    EXPECT_NEAR(amplification(point, medium, 0.5 * StandardGravity / omega) / table.at(row, "H_over_H0"), 1.0, 1e-5)
      << u;
  }
}

TEST_F(ReferenceCurrents, jets)
{
  struct Jet
  {
    const char* name;
    const char* spec;
    double depth;
    double period;
  };
  for (const Jet& jet :
    { Jet{ "c8_jet_1", "jet:V0=2,w=200", DeepBed, 10.0 }, Jet{ "c8_jet_2", "jet:V0=-2.5,w=250", DeepBed, 10.0 },
      Jet{ "c8_jet_3", "jet:V0=1.5,w=150", 12.0, 9.0 }, Jet{ "c8_jet_4", "jet:V0=3,w=200", DeepBed, 10.0 } })
  {
    const ReferenceTable table(jet.name);
    ASSERT_FALSE(table.empty()) << jet.name;
    const auto current = makeBuiltinCurrent(jet.spec);
    const FlatBed bed(Scene, jet.depth);
    const RayMedium medium = mediumWith(bed, *current, jet.period);
    RayStart start;
    start.position = { table.at(0, "x"), table.at(0, "y") };
    start.wavenumber = { table.at(0, "kx"), table.at(0, "ky") };
    start.dPosition = { 0.0, std::hypot(table.at(0, "Gx"), table.at(0, "Gy")) / table.at(0, "Gx") };
    const double groupSpeed0 = std::hypot(table.at(0, "Gx"), table.at(0, "Gy") - current->velocity(start.position).y);
    HamiltonianRay ray(medium, start, Tolerance);
    RayPoint point;
    for (std::size_t row = 0; row < table.size(); ++row)
    {
      ASSERT_TRUE(ray.advance(FrontMeasure::Time, table.at(row, "t"), point)) << jet.name;
      // The table is good for 5e-9 m; a ray adds about as much a km.
      EXPECT_NEAR(point.position.x, table.at(row, "x"), 1e-6) << jet.name;
      EXPECT_NEAR(point.position.y, table.at(row, "y"), 1e-6) << jet.name;
      EXPECT_NEAR(point.wavenumber.x, table.at(row, "kx"), 1e-10) << jet.name;
      EXPECT_NEAR(point.wavenumber.y, table.at(row, "ky"), 1e-12) << jet.name;
      const double height = amplification(point, medium, groupSpeed0);
      // Heights are infinite where the ray turns, and errors grow towards it.
      if (std::isfinite(table.at(row, "H_over_H0")) && table.at(row, "H_over_H0") < 10.0)
      {
        EXPECT_NEAR(height / table.at(row, "H_over_H0"), 1.0,
          1e-7 * table.at(row, "H_over_H0") * table.at(row, "H_over_H0") * table.at(row, "H_over_H0") *
            table.at(row, "H_over_H0"))
          << jet.name << " " << table.at(row, "x");
        EXPECT_EQ(point.caustics, static_cast<int>(table.at(row, "kmah"))) << jet.name << " " << table.at(row, "x");
      }
    }
  }
}

TEST_F(ReferenceCurrents, eddy)
{
  const ReferenceTable table("c8_eddy");
  ASSERT_FALSE(table.empty());
  const auto current = makeBuiltinCurrent("eddy:U0=1.5,R=300");
  const FlatBed bed(Scene, DeepBed);
  const RayMedium medium = mediumWith(bed, *current, 10.0);
  std::unique_ptr<HamiltonianRay> ray;
  double b = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    if (!(table.at(row, "b") == b))
    {
      b = table.at(row, "b");
      RayStart start;
      start.position = { table.at(row, "x"), table.at(row, "y") };
      start.wavenumber = { table.at(row, "kx"), table.at(row, "ky") };
      start.dPosition = { 0.0, 1.0 };
      ray = std::make_unique<HamiltonianRay>(medium, start, Tolerance);
    }
    RayPoint point;
    ASSERT_TRUE(ray->advance(FrontMeasure::Time, table.at(row, "t"), point));
    EXPECT_NEAR(point.position.x, table.at(row, "x"), 1e-6) << b; // the table: 1e-7 m
    EXPECT_NEAR(point.position.y, table.at(row, "y"), 1e-6) << b;
    EXPECT_NEAR(point.wavenumber.x, table.at(row, "kx"), 1e-10) << b;
    EXPECT_NEAR(point.wavenumber.y, table.at(row, "ky"), 1e-10) << b;
  }
}
