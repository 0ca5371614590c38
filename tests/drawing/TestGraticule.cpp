#include "apps/drawing/Graticule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace swellray;
using namespace swellray::drawing;

namespace
{

// A line is straight between places 1/64 of the map apart: of a map 100 km wide at 60 degrees that is off by
// (1.6 km)^2 tan(60)/8 R = 0.08 m, 1e-6 degrees.
constexpr double Straight = 2e-6;

}

TEST(Graticule, WritesDegreesMinutesAndSeconds)
{
  EXPECT_EQ(degreesMinutes(-73.5, true), "73\u00b030' W");
  EXPECT_EQ(degreesMinutes(41.0, false), "41\u00b0 N");
  EXPECT_EQ(degreesMinutes(-0.25, false), "0\u00b015' S");
  EXPECT_EQ(degreesMinutes(4.0 + 36.0 / 60.0 + 30.0 / 3600.0, true), "4\u00b036'30\" E");
  EXPECT_EQ(degreesMinutes(0.0, true), "0\u00b0");
  EXPECT_EQ(degreesMinutes(190.0, true), "170\u00b0 W");
  EXPECT_EQ(degreesMinutes(-180.0, true), "180\u00b0");
}

TEST(Graticule, LinesLieWhereTheirDegreesAre)
{
  const Georeference place("EPSG:4326", { 10.0, 60.0 }, { 0.0, 0.0 });
  const double bounds[4] = { -50000.0, 50000.0, -40000.0, 40000.0 };
  const auto lines = makeGraticule(place, bounds);
  std::set<double> meridians;
  std::set<double> parallels;
  for (const GraticuleLine& line : lines)
  {
    (line.meridian ? meridians : parallels).insert(line.degrees);
    ASSERT_GE(line.points.size(), 2U);
    for (const glm::dvec2& point : line.points)
    {
      EXPECT_GE(point.x, bounds[0]);
      EXPECT_LE(point.x, bounds[1]);
      EXPECT_GE(point.y, bounds[2]);
      EXPECT_LE(point.y, bounds[3]);
      const auto lonLat = place.toLonLat(point);
      ASSERT_TRUE(lonLat);
      EXPECT_NEAR(line.meridian ? lonLat->x : lonLat->y, line.degrees, Straight);
    }
    // From one edge to the other.
    EXPECT_EQ(line.meridian ? line.points.front().y : line.points.front().x, line.meridian ? bounds[2] : bounds[0]);
  }
  // 100 km are 1.8 degrees of longitude there, 80 km 0.72 of latitude.
  EXPECT_EQ(meridians.size(), 3U);
  EXPECT_TRUE(meridians.count(9.5) && meridians.count(10.0) && meridians.count(10.5));
  EXPECT_TRUE(parallels.count(60.0));
  EXPECT_GE(parallels.size(), 3U);
}

TEST(Graticule, GoesOnAcrossTheAntimeridian)
{
  const Georeference place("EPSG:4326", { 180.0, -17.0 }, { 0.0, 0.0 });
  const double bounds[4] = { -200000.0, 200000.0, -200000.0, 200000.0 };
  std::set<std::string> labels;
  for (const GraticuleLine& line : makeGraticule(place, bounds))
  {
    labels.insert(line.label);
    if (line.meridian)
    {
      EXPECT_GT(line.points.size(), 60U); // whole
    }
  }
  EXPECT_TRUE(labels.count("179\u00b0 E"));
  EXPECT_TRUE(labels.count("180\u00b0"));
  EXPECT_TRUE(labels.count("179\u00b0 W"));
}

TEST(Graticule, HasNoLinesWithoutAReferenceSystem)
{
  const double bounds[4] = { 0.0, 100.0, 0.0, 100.0 };
  EXPECT_TRUE(makeGraticule(Georeference(), bounds).empty());
}
