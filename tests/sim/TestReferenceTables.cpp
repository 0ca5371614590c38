// Rays against tables of reference solutions, where these lie beside the data folder.
#include "MapOfEarth.h"
#include "RayComparison.h"
#include "ReferenceTable.h"

#include "sim/BuiltinSeafloor.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

using namespace swellray;
using namespace swellray::reference;
using swellray::testing::referenceFolder;
using swellray::testing::ReferenceTable;

namespace
{

constexpr double Tolerance = 1e-12;

using Table = ReferenceTable;

class ReferenceTables : public ::testing::Test
{
protected:
  void SetUp() override
  {
    if (!std::filesystem::is_directory(referenceFolder()))
    {
      GTEST_SKIP() << "no reference tables in " << referenceFolder();
    }
  }

  static Table load(const std::string& name)
  {
    Table table(name);
    EXPECT_GT(table.size(), 0u) << name;
    return table;
  }
};

// Errors that the tables state for themselves, and what the rays add at tolerance 1e-12 (below 1e-9 m a km).
struct Allowed
{
  double position; // m a km
  double theta;
  double relative; // phase, time
  double width;
};

void expectWithin(const RayErrors& errors, const Allowed& allowed, const std::string& name)
{
  EXPECT_GT(errors.places, 0) << name;
  EXPECT_LT(errors.position, allowed.position) << name << ": " << errors;
  EXPECT_LT(errors.theta, allowed.theta) << name << ": " << errors;
  EXPECT_LT(errors.phase, allowed.relative) << name << ": " << errors;
  EXPECT_LT(errors.time, allowed.relative) << name << ": " << errors;
  EXPECT_LT(errors.width, allowed.width) << name << ": " << errors;
  EXPECT_EQ(errors.caustics, 0) << name << ": " << errors;
}

}

TEST_F(ReferenceTables, straightBeaches)
{
  struct Beach
  {
    const char* name;
    const char* spec;
    double period;
    double theta0; // degrees
  };
  const std::string scene = ",x0=-100,x1=12100,y0=-40000,y1=40000";
  for (const Beach& beach :
    { Beach{ "c2_plane_A", "plane:s=0.02", 10.0, 45.0 }, Beach{ "c2_plane_B", "plane:s=0.05", 7.0, 30.0 },
      Beach{ "c2_plane_C_deep70", "plane:s=0.01", 12.0, 70.0 }, Beach{ "c5_dean_A", "dean:A=0.12", 9.0, 40.0 },
      Beach{ "c5_bar_A", "bar:s=0.02,hb=2,xb=200,wb=40", 9.0, 40.0 } })
  {
    const Table table = load(beach.name);
    const auto seafloor = makeBuiltinSeafloor(beach.spec + scene);
    const RayMedium medium = mediumOf(*seafloor, beach.period, 0.01);
    const double theta0 = radians(beach.theta0);
    const double groupSpeed0 = table.at(0, "Cg");
    HamiltonianRay ray(medium,
      startHeading(medium, { table.at(0, "x"), 0.0 }, swellray::Pi - theta0, { 0.0, -1.0 / std::cos(theta0) }),
      Tolerance);
    RayErrors errors;
    RayPoint point;
    for (std::size_t i = 1; i < table.size(); ++i)
    {
      Place place;
      place.x = table.at(i, "x");
      place.y = table.at(i, "y");
      place.theta = swellray::Pi - table.at(i, "theta_rad");
      place.phase = table.at(i, "S_phase_rad");
      place.time = table.at(i, "t_travel_s");
      place.length = 1000.0; // not in the table; errors count a km
      place.width = 1.0 / (table.at(i, "Kr") * table.at(i, "Kr"));
      ASSERT_TRUE(ray.advance(FrontMeasure::Phase, place.phase, point)) << beach.name;
      errors.add(point, place);
      const double groupSpeed = waveSpeeds(glm::length(point.wavenumber), point.depth).groupSpeed;
      EXPECT_NEAR(shoalingCoefficient(groupSpeed0, groupSpeed), table.at(i, "Ks"), 1e-9) << beach.name;
    }
    // Stated: 1e-7 m, 4e-11 for the rest.
    expectWithin(errors, { 2e-7, 2e-10, 2e-10, 5e-10 }, beach.name);
  }
}

TEST_F(ReferenceTables, trappedRays)
{
  struct Trapped
  {
    const char* name;
    const char* slope;
    double period;
  };
  for (const Trapped& c :
    { Trapped{ "c5_trapped_plane_1", "0.02", 10.0 }, Trapped{ "c5_trapped_plane_2", "0.01", 60.0 } })
  {
    const Table table = load(c.name);
    const auto seafloor =
      makeBuiltinSeafloor(std::string("plane:s=") + c.slope + ",x0=-1000,x1=20000,y0=-50000,y1=50000");
    const RayMedium medium = mediumOf(*seafloor, c.period, 0.01);
    const double theta0 = radians(table.at(0, "theta_deg"));
    HamiltonianRay ray(
      medium, startHeading(medium, { table.at(0, "x"), 0.0 }, theta0, { 0.0, 1.0 / std::cos(theta0) }), Tolerance);
    RayErrors errors;
    RayPoint point;
    for (std::size_t i = 1; i < table.size(); ++i)
    {
      Place place;
      place.x = table.at(i, "x");
      place.y = table.at(i, "y");
      place.theta = radians(table.at(i, "theta_deg"));
      place.phase = table.at(i, "S");
      place.time = table.at(i, "t");
      place.length = 1000.0;
      place.width = table.at(i, "q");
      ASSERT_TRUE(ray.advance(FrontMeasure::Phase, place.phase, point)) << c.name;
      // At the turning point itself the width is 0, its sign rounding.
      place.caustics = std::abs(place.width) < 1e-9 ? point.caustics : static_cast<int>(table.at(i, "kmah"));
      errors.add(point, place);
    }
    // Stated: 1e-9 m, 1e-12 for the rest.
    expectWithin(errors, { 3e-9, 2e-10, 2e-10, 1e-9 }, c.name);
  }
}

TEST_F(ReferenceTables, circularShoalsAndIslands)
{
  struct Circular
  {
    const char* name;
    const char* spec;
    double period;
    double x0;
    Allowed allowed; // stated: q 4e-10 on shoals, 7e-8 on islands, position 9e-8, 3e-8, 2e-7, 5e-7 m
  };
  const std::string scene = ",x0=-6000,x1=6000,y0=-6000,y1=6000";
  for (const Circular& c :
    { Circular{ "c4_shoal_gauss", "shoal:kind=gauss,h0=20,a=14,sg=300", 10.0, -1800.0, { 9e-8, 1e-9, 1e-10, 2e-9 } },
      Circular{ "c4_shoal_poly3", "shoal:kind=poly3,h0=15,a=10.5,R=250", 8.0, -300.0, { 3e-8, 1e-9, 1e-10, 2e-9 } },
      Circular{
        "c4_island_cone", "island:kind=conical,s=0.05,rs=200,rt=1000", 12.0, -1500.0, { 2e-7, 1e-9, 1e-10, 7e-8 } },
      Circular{
        "c4_island_parabolic", "island:kind=parabolic,h0=30,R=1200", 14.0, -1800.0, { 5e-7, 1e-9, 1e-10, 7e-8 } } })
  {
    const Table table = load(c.name);
    const auto seafloor = makeBuiltinSeafloor(c.spec + scene);
    const RayMedium medium = mediumOf(*seafloor, c.period, 0.1);
    RayErrors errors;
    std::unique_ptr<HamiltonianRay> ray;
    RayPoint point;
    for (std::size_t i = 0; i < table.size(); ++i)
    {
      const double b = table.at(i, "b");
      if (i == 0 || b != table.at(i - 1, "b"))
      {
        ray = std::make_unique<HamiltonianRay>(medium, startHeading(medium, { c.x0, b }, 0.0, { 0.0, 1.0 }), Tolerance);
      }
      Place place;
      place.x = table.at(i, "x");
      place.y = table.at(i, "y");
      place.theta = table.at(i, "theta");
      place.phase = table.at(i, "S");
      place.time = table.at(i, "t");
      place.length = table.at(i, "s");
      place.width = table.at(i, "q");
      place.caustics = static_cast<int>(table.at(i, "kmah"));
      ASSERT_TRUE(ray->advance(FrontMeasure::Length, place.length, point)) << c.name << " b = " << b;
      errors.add(point, place);
    }
    expectWithin(errors, c.allowed, c.name);
    if (!std::filesystem::exists(referenceFolder() / (std::string(c.name) + "_caustic.csv")))
    {
      continue;
    }
    const Table caustics = load(std::string(c.name) + "_caustic");
    for (std::size_t i = 0; i < caustics.size(); ++i)
    {
      const double b = caustics.at(i, "b");
      const double s = caustics.at(i, "s");
      HamiltonianRay again(medium, startHeading(medium, { c.x0, b }, 0.0, { 0.0, 1.0 }), Tolerance);
      // Stated: 1e-8 m along the ray, on which q passes 0 at a rate of up to 1e-1/m.
      constexpr double aside = 1e-5;
      RayPoint before;
      RayPoint after;
      ASSERT_TRUE(again.advance(FrontMeasure::Length, s - aside, before));
      ASSERT_TRUE(again.advance(FrontMeasure::Length, s, point));
      ASSERT_TRUE(again.advance(FrontMeasure::Length, s + aside, after));
      const double rate = (after.tubeWidth - before.tubeWidth) / (2.0 * aside);
      EXPECT_LT(std::abs(point.tubeWidth / rate), 1e-7) << c.name << " b = " << b;
      EXPECT_EQ(before.caustics, static_cast<int>(caustics.at(i, "j")) - 1) << c.name << " b = " << b;
      EXPECT_EQ(after.caustics, before.caustics + 1) << c.name << " b = " << b;
      EXPECT_NEAR(point.position.x, caustics.at(i, "x"), 1e-7) << c.name << " b = " << b;
      EXPECT_NEAR(point.position.y, caustics.at(i, "y"), 1e-7) << c.name << " b = " << b;
      EXPECT_NEAR(point.phase, caustics.at(i, "S"), 1e-8) << c.name << " b = " << b;
    }
  }
}

TEST_F(ReferenceTables, ellipticShoal)
{
  const Table table = load("c7c_berkhoff_rays");
  const auto seafloor = makeBuiltinSeafloor("berkhoff:x0=-20,x1=20,y0=-20,y1=20");
  const RayMedium medium = mediumOf(*seafloor, 1.0, 0.01);
  RayErrors errors;
  std::unique_ptr<HamiltonianRay> ray;
  RayPoint point;
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const double y0 = table.at(i, "y0");
    if (i == 0 || y0 != table.at(i - 1, "y0"))
    {
      ray = std::make_unique<HamiltonianRay>(medium, startHeading(medium, { -10.0, y0 }, 0.0, { 0.0, 1.0 }), Tolerance);
    }
    Place place;
    place.x = table.at(i, "x");
    place.y = table.at(i, "y");
    place.theta = table.at(i, "theta");
    place.phase = table.at(i, "S");
    place.time = table.at(i, "t");
    place.width = table.at(i, "q");
    place.caustics = static_cast<int>(table.at(i, "kmah"));
    ASSERT_TRUE(ray->advance(FrontMeasure::Phase, place.phase, point)) << "y0 = " << y0;
    errors.add(point, place);
    EXPECT_NEAR(point.depth, table.at(i, "h"), 1e-9);
  }
  // Stated: 1e-9 m, q 9e-9 by neighbours.
  expectWithin(errors, { 1e-8, 1e-8, 1e-9, 1e-7 }, "c7c_berkhoff_rays");

  const Table caustics = load("c7c_berkhoff_caustic");
  for (std::size_t i = 0; i < caustics.size(); ++i)
  {
    const double y0 = caustics.at(i, "y0");
    HamiltonianRay again(medium, startHeading(medium, { -10.0, y0 }, 0.0, { 0.0, 1.0 }), Tolerance);
    // The table gives no arc length: look along the ray for the place nearest to its point.
    const glm::dvec2 wanted(caustics.at(i, "x"), caustics.at(i, "y"));
    ASSERT_TRUE(again.advance(FrontMeasure::Length, wanted.x + 9.9, point)) << "y0 = " << y0;
    for (int step = 0; step < 6; ++step)
    {
      const double ahead = glm::dot(wanted - point.position, point.rayDirection);
      ASSERT_TRUE(again.advance(FrontMeasure::Length, again.length() + std::max(0.0, ahead), point));
    }
    EXPECT_LT(glm::length(point.position - wanted), 1e-7) << "y0 = " << y0;
    // q passes 0 there at a rate of order 1/m.
    EXPECT_LT(std::abs(point.tubeWidth), 1e-6) << "y0 = " << y0;
    EXPECT_NEAR(std::atan2(point.wavenumber.y, point.wavenumber.x), caustics.at(i, "theta"), 1e-7) << "y0 = " << y0;
  }
}

TEST_F(ReferenceTables, curvesByDesign)
{
  struct Design
  {
    const char* name;
    // k/k0 of x, y in units of 1000 m
    std::function<Jet(const Jet& x, const Jet& y)> ratio;
    double heading; // degrees
  };
  const auto radius = [](const Jet& x, const Jet& y) { return sqrt(x * x + y * y); };
  const double omega = 2.0 * swellray::Pi / 10.0;
  const double k0 = static_cast<double>(wavenumber(omega, 12.0));
  for (const Design& design : { Design{ "c3_design_circle", [](const Jet&x, const Jet&) { return 1000.0 / x; }, 135.0 },
         Design{ "c3_design_cycloid", [](const Jet&x, const Jet&) { return sqrt(1000.0 / x); }, 135.0 },
         Design{ "c3_design_spiral_island", [&](const Jet&x, const Jet&y) { return 1000.0 / radius(x, y); }, 140.0 },
         Design{ "c3_design_parabola_island", [&](const Jet&x, const Jet&y) { return sqrt(1000.0 / radius(x, y)); },
           140.0 } })
  {
    const Table table = load(design.name);
    Formula formula;
    formula.depth = [&](const Jet& x, const Jet& y, unsigned) { return depthFormula(omega, k0 * design.ratio(x, y)); };
    const FormulaSeafloor bed(formula, { { -3000.0, -3000.0 }, { 3000.0, 3000.0 } }, 50.0);
    const RayMedium medium = mediumOf(bed, 10.0, 1e-3);
    HamiltonianRay ray(medium, startHeading(medium, { 1000.0, 0.0 }, radians(design.heading), { 0.0, 1.0 }), Tolerance);
    RayPoint point;
    double length = 0.0;
    for (std::size_t i = 1; i < table.size(); ++i)
    {
      // The tables give no arc length: go on until the place is abreast.
      const glm::dvec2 wanted(table.at(i, "x"), table.at(i, "y"));
      const glm::dvec2 last(table.at(i - 1, "x"), table.at(i - 1, "y"));
      length += glm::length(wanted - last);
      ASSERT_TRUE(ray.advance(FrontMeasure::Length, length, point)) << design.name;
      for (int step = 0; step < 8; ++step)
      {
        length += std::max(0.0, glm::dot(wanted - point.position, point.rayDirection));
        ASSERT_TRUE(ray.advance(FrontMeasure::Length, length, point)) << design.name;
      }
      EXPECT_LT(glm::length(point.position - wanted), 3e-9) << design.name << " row " << i;
      EXPECT_NEAR(point.depth, table.at(i, "h"), 1e-9) << design.name << " row " << i;
    }
  }
}

TEST_F(ReferenceTables, luneburgLensAndFoldParabola)
{
  const double omega = 2.0 * swellray::Pi / 10.0;
  {
    const Table table = load("c3_design_luneburg");
    const double k0 = static_cast<double>(wavenumber(omega, 15.0));
    constexpr double R = 500.0;
    Formula formula;
    formula.depth = [&](const Jet& x, const Jet& y, unsigned region)
    { return depthFormula(omega, region ? Jet(k0) : k0 * sqrt(Jet(2.0) - (x * x + y * y) / (R * R))); };
    formula.kinks.push_back([](const Jet& x, const Jet& y) { return x * x + y * y - Jet(R * R); });
    const FormulaSeafloor bed(formula, { { -900.0, -900.0 }, { 900.0, 900.0 } }, 50.0);
    const RayMedium medium = mediumOf(bed, 10.0, 1e-3);
    for (std::size_t i = 0; i < table.size(); ++i)
    {
      const double b = table.at(i, "b");
      const double w = table.at(i, "w");
      HamiltonianRay ray(medium, startHeading(medium, { -R, b }, 0.0, { 0.0, 1.0 }), Tolerance);
      RayPoint point;
      const double root = std::sqrt(R * R - b * b);
      const double phase = k0 * (R - root + R * w + root * std::sin(w) * std::sin(w));
      ASSERT_TRUE(ray.advance(FrontMeasure::Phase, phase, point));
      EXPECT_NEAR(point.position.x, table.at(i, "x"), 3e-9) << "b = " << b << " w = " << w;
      EXPECT_NEAR(point.position.y, table.at(i, "y"), 3e-9) << "b = " << b << " w = " << w;
      EXPECT_NEAR(std::atan2(point.wavenumber.y, point.wavenumber.x), table.at(i, "theta_rad"), 1e-10) << "b = " << b;
      EXPECT_NEAR(point.depth, table.at(i, "h"), 1e-9) << "b = " << b << " w = " << w;
    }
  }
  {
    const Table table = load("c3_design_fold_parabola");
    const double k0 = static_cast<double>(wavenumber(omega, 5.0));
    constexpr double mu = 3.5910542349700442e-06;
    Formula formula;
    formula.depth = [&](const Jet& x, const Jet&, unsigned)
    { return depthFormula(omega, sqrt(Jet(k0 * k0) - mu * x)); };
    const FormulaSeafloor bed(formula, { { -500.0, -100.0 }, { 900.0, 9000.0 } }, 50.0);
    const RayMedium medium = mediumOf(bed, 10.0, 1e-3);
    const double theta0 = radians(65.0);
    HamiltonianRay ray(medium, startHeading(medium, { 0.0, 0.0 }, theta0, { 0.0, 1.0 / std::cos(theta0) }), Tolerance);
    for (std::size_t i = 1; i < table.size(); ++i)
    {
      const double tau = table.at(i, "tau");
      const double kx = k0 * std::cos(theta0);
      RayPoint point;
      ASSERT_TRUE(ray.advance(
        FrontMeasure::Phase, k0 * k0 * tau - 0.5 * mu * kx * tau * tau + mu * mu * tau * tau * tau / 12.0, point));
      EXPECT_NEAR(point.position.x, table.at(i, "x"), 3e-9);
      EXPECT_NEAR(point.position.y, table.at(i, "y"), 3e-9);
      EXPECT_NEAR(point.depth, table.at(i, "h"), 1e-9);
    }
  }
}

TEST_F(ReferenceTables, geodesicsOfDeepWater)
{
  const Table table = load("c9_geodesic");
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double longitude = table.at(row, "lon1");
    const EllipsoidMercator map(6378137.0, 1.0 / 298.257223563, longitude, 0.0);
    const ZonalSeafloor deep(
      [](double, double& h, double& h1, double& h2)
      {
        h = 1e5;
        h1 = h2 = 0.0;
      },
      map, { map.toMap({ longitude - 360.0, -84.0 }), map.toMap({ longitude + 360.0, 84.0 }) });
    RayMedium medium = mediumOf(deep, 15.0, 0.1);
    medium.map = &map;
    const glm::dvec2 from = map.toMap({ longitude, table.at(row, "lat1") });
    // A fan by the heading: its width is the reduced length.
    RayStart start = startAzimuth(medium, from, radians(table.at(row, "azi1")), glm::dvec2(0.0));
    start.dWavenumber = glm::dvec2(-start.wavenumber.y, start.wavenumber.x);
    HamiltonianRay ray(medium, start, Tolerance);
    RayPoint point;
    ASSERT_TRUE(ray.advance(FrontMeasure::Length, table.at(row, "s12"), point));
    const glm::dvec2 place = map.toLonLat(point.position);
    constexpr double degree = 1e-12; // the table states 6e-14; a tenth of a micrometre on the ground
    EXPECT_NEAR(place.y, table.at(row, "lat2"), degree);
    EXPECT_NEAR(std::remainder(place.x - table.at(row, "lon2"), 360.0), 0.0, degree);
    EXPECT_NEAR(degrees(std::atan2(point.wavenumber.x, point.wavenumber.y)), table.at(row, "azi2"), 1e-10);
    EXPECT_NEAR(point.tubeWidth, table.at(row, "m12"), 1e-3);
    EXPECT_NEAR(point.travelTime, table.at(row, "travel_s_T15"), 1e-9 * point.travelTime);
  }
}

TEST_F(ReferenceTables, zonalDepthOnTheEllipsoid)
{
  const Table table = load("c9_zonal_depth");
  const double longitude = 10.0;
  const EllipsoidMercator map(6378137.0, 1.0 / 298.257223563, longitude, -20.0);
  const ZonalSeafloor zones(
    [](double phi, double& h, double& h1, double& h2)
    {
      h = 4000.0 + 1500.0 * std::sin(3.0 * phi);
      h1 = 4500.0 * std::cos(3.0 * phi);
      h2 = -13500.0 * std::sin(3.0 * phi);
    },
    map, { map.toMap({ longitude - 360.0, -84.0 }), map.toMap({ longitude + 360.0, 84.0 }) });
  RayMedium medium = mediumOf(zones, 1200.0, 0.1);
  medium.map = &map;
  std::unique_ptr<HamiltonianRay> ray;
  RayPoint point;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double length = table.at(row, "s");
    if (length == 0.0)
    {
      const RayStart start =
        startAzimuth(medium, map.toMap({ longitude, -45.0 }), radians(table.at(row, "az0")), glm::dvec2(0.0));
      ray = std::make_unique<HamiltonianRay>(medium, start, Tolerance);
    }
    ASSERT_TRUE(ray->advance(FrontMeasure::Length, length, point));
    const glm::dvec2 wanted = map.toMap({ table.at(row, "lon"), table.at(row, "lat") });
    // The table states 2e-6 m.
    EXPECT_LT(glm::length(point.position - wanted) / map.scale(wanted), 5e-6) << length;
    EXPECT_NEAR(point.depth, table.at(row, "h"), 1e-8);
  }
}

TEST_F(ReferenceTables, deepWaterToAnyDepth)
{
  const Table table = load("c2_deep_to_depth");
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const double period = table.at(i, "T");
    const double depth = table.at(i, "h");
    const double omega = 2.0 * swellray::Pi / period;
    const double k0 = omega * omega / StandardGravity;
    const double k = solveWavenumber(omega, depth);
    const double theta0 = radians(table.at(i, "theta_deep_deg"));
    const double theta = std::asin(std::sin(theta0) * k0 / k);
    EXPECT_NEAR(degrees(theta), table.at(i, "theta_deg"), 1e-12);
    EXPECT_NEAR(shoalingCoefficient(0.5 * omega / k0, waveSpeeds(k, depth).groupSpeed), table.at(i, "Ks"), 1e-13);
    EXPECT_NEAR(std::sqrt(std::cos(theta0) / std::cos(theta)), table.at(i, "Kr"), 1e-13);
  }
}
