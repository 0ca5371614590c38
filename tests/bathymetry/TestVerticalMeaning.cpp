#include "bathymetry/VerticalMeaning.h"

#include <gtest/gtest.h>

using namespace swellray;

namespace
{

VerticalMeaning meaningOf(const std::string& positive, const std::string& standardName, const std::string& units = "m",
  Positive asked = Positive::Auto)
{
  return understandVertical({ positive, standardName, units, "", "", "" }, asked);
}

}

TEST(VerticalMeaning, Sign)
{
  EXPECT_EQ(meaningOf("", "").factor, 1.0);
  EXPECT_EQ(meaningOf("", "").signSource, "assumed");
  EXPECT_EQ(meaningOf("Down", "").factor, -1.0);
  EXPECT_EQ(meaningOf("up", "altitude").factor, 1.0);
  EXPECT_EQ(meaningOf("", "depth").factor, -1.0);
  EXPECT_EQ(meaningOf("", "sea_floor_depth_below_mean_sea_level").factor, -1.0);
  EXPECT_EQ(meaningOf("", "height_above_mean_sea_level").factor, 1.0);
  EXPECT_EQ(meaningOf("", "sea_surface_temperature").signSource, "assumed");
  EXPECT_EQ(meaningOf("", "", "m", Positive::Down).factor, -1.0);
  EXPECT_EQ(meaningOf("down", "", "m", Positive::Up).factor, 1.0);
  EXPECT_EQ(understandVertical({ "", "", "m", "down", "vertical CRS", "" }, Positive::Auto).factor, -1.0);
  EXPECT_EQ(understandVertical({ "up", "", "m", "down", "vertical CRS", "" }, Positive::Auto).factor, 1.0);
  EXPECT_EQ(meaningOf("sideways", "").notes.size(), 1u);
}

TEST(VerticalMeaning, ContradictionIsAnErrorUnlessTheCallerDecides)
{
  EXPECT_THROW(meaningOf("up", "depth"), std::runtime_error);
  EXPECT_THROW(meaningOf("down", "altitude"), std::runtime_error);
  EXPECT_EQ(meaningOf("up", "depth", "m", Positive::Down).factor, -1.0);
}

TEST(VerticalMeaning, Units)
{
  EXPECT_EQ(metresPerUnit("m"), 1.0);
  EXPECT_EQ(metresPerUnit("Metres"), 1.0);
  EXPECT_EQ(metresPerUnit("meters above MSL"), 1.0);
  EXPECT_EQ(metresPerUnit("m (NAVD88)"), 1.0);
  EXPECT_EQ(metresPerUnit("cm"), 0.01);
  EXPECT_EQ(metresPerUnit("feet"), 0.3048);
  EXPECT_EQ(metresPerUnit("fathoms"), 1.8288);
  EXPECT_EQ(metresPerUnit("US survey foot"), 1200.0 / 3937.0);
  EXPECT_EQ(metresPerUnit("mb"), 0.0);
  EXPECT_EQ(metresPerUnit("mmol"), 0.0);
  EXPECT_EQ(metresPerUnit("degrees_north"), 0.0);
  EXPECT_EQ(metresPerUnit(""), 0.0);
  EXPECT_DOUBLE_EQ(meaningOf("down", "", "fathoms").factor, -1.8288);
  EXPECT_EQ(meaningOf("", "", "").unitsSource, "assumed");
  EXPECT_EQ(meaningOf("", "", "m").unitsSource, "units 'm'");
  EXPECT_EQ(understandVertical({ "", "", "m", "down", "the format", "SWAN's unit" }, Positive::Auto).unitsSource,
    "SWAN's unit");
  EXPECT_EQ(meaningOf("", "", "kelvin").factor, 1.0);
  EXPECT_EQ(meaningOf("", "", "kelvin").notes.size(), 1u);
}
