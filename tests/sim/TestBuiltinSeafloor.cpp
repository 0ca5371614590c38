// The built-in seafloors as users call them: their formulas, the registry, and what a wrong call is told.
#include "sim/BuiltinSeafloor.h"

#include "sim/Angles.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>

using namespace swellray;

namespace
{

// The same formula written another way differs by rounding of depths up to some 100 m.
constexpr double FormulaTolerance = 1e-11;

using Depth = std::function<double(double, double)>;

void expectDepth(const std::string& spec, const Depth& depth, const Rectangle& box)
{
  SCOPED_TRACE(spec);
  const std::unique_ptr<Seafloor> bed = makeBuiltinSeafloor(spec);
  constexpr int Count = 60;
  for (int k = 0; k < Count * Count; ++k)
  {
    const glm::dvec2 p = box.low + box.size() * glm::dvec2((k % Count + 0.4) / Count, (k / Count + 0.7) / Count);
    ASSERT_NEAR(-bed->elevation(p), depth(p.x, p.y), FormulaTolerance) << "at " << p.x << ", " << p.y;
  }
}

std::string errorOf(const std::string& spec)
{
  try
  {
    makeBuiltinSeafloor(spec);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "no error";
}

TEST(BuiltinSeafloor, planeBeach)
{
  const Rectangle box{ { -500.0, -900.0 }, { 2000.0, 900.0 } };
  expectDepth(
    "plane", [](double x, double) { return 0.02 * x; }, box);
  expectDepth(
    "plane:slope=0.05", [](double x, double) { return 0.05 * x; }, box);
  expectDepth(
    "plane:facing=0", [](double, double y) { return 0.02 * y; }, box);
  expectDepth(
    "plane:facing=270", [](double x, double) { return -0.02 * x; }, box);
  expectDepth(
    "plane:facing=225,s=0.01", [](double x, double y) { return -0.01 * (x + y) * std::sqrt(0.5); }, box);
  expectDepth(
    "plane:offshore-depth=12", [](double x, double) { return std::min(0.02 * x, 12.0); }, box);
}

TEST(BuiltinSeafloor, deanBeach)
{
  // x = 0.5 m is 0.05 m deep at A = 0.08.
  const Rectangle wet{ { 0.5, -100.0 }, { 3000.0, 100.0 } };
  expectDepth(
    "dean:A=0.08", [](double x, double) { return 0.08 * std::pow(x, 2.0 / 3.0); }, wet);
  expectDepth(
    "dean:scale=0.12,x1=3500", [](double x, double) { return 0.12 * std::pow(x, 2.0 / 3.0); }, wet);
}

TEST(BuiltinSeafloor, deanBeachRisesAboveWater)
{
  const std::unique_ptr<Seafloor> bed = makeBuiltinSeafloor("dean");
  double previous = bed->elevation({ 1.0, 0.0 });
  for (double x = 0.99; x > -100.0; x -= 0.01)
  {
    const double elevation = bed->elevation({ x, 0.0 });
    ASSERT_GT(elevation, previous);
    previous = elevation;
  }
  EXPECT_GT(bed->elevation({ -10.0, 0.0 }), 0.5);
}

TEST(BuiltinSeafloor, joinsInsideAFormKeepTwoDerivatives)
{
  const struct
  {
    const char* spec;
    double join; // m along +x
  } joins[] = { { "dean:A=0.08,min-depth=0.32", 8.0 }, { "island:s=0.1,rs=100,rt=500", 50.0 } };
  // A billionth of the distance apart, third derivatives change the second ones by no more than that.
  constexpr double Apart = 1e-9;
  constexpr double Tolerance = 1e-7;
  for (const auto& [spec, join] : joins)
  {
    SCOPED_TRACE(spec);
    const std::unique_ptr<Seafloor> bed = makeBuiltinSeafloor(spec);
    const BedSample inside = bed->bed({ join * (1.0 - Apart), 0.0 });
    const BedSample outside = bed->bed({ join * (1.0 + Apart), 0.0 });
    const double slope = glm::length(outside.gradient);
    EXPECT_NEAR(inside.elevation, outside.elevation, Tolerance * slope * join);
    EXPECT_NEAR(inside.gradient.x, outside.gradient.x, Tolerance * slope);
    EXPECT_NEAR(inside.xx, outside.xx, Tolerance * slope / join);
    EXPECT_NEAR(inside.yy, outside.yy, Tolerance * slope / join);
  }
}

TEST(BuiltinSeafloor, barBeach)
{
  const Rectangle box{ { -100.0, -100.0 }, { 1500.0, 100.0 } };
  expectDepth(
    "bar:s=0.02,hb=2,xb=200,wb=40",
    [](double x, double) { return 0.02 * x - 2.0 * std::exp(-(x - 200.0) * (x - 200.0) / 1600.0); }, box);
  expectDepth(
    "bar:slope=0.03,bar-height=1,bar-position=120,bar-width=30,offshore-depth=4",
    [](double x, double) { return std::min(0.03 * x - std::exp(-std::pow((x - 120.0) / 30.0, 2)), 4.0); }, box);
}

TEST(BuiltinSeafloor, bayAndHeadland)
{
  const auto coast = [](double slope, double reach, double sigma, double fade)
  {
    return [=](double x, double y)
    {
      const double shore = reach * (1.0 - y * y / (sigma * sigma)) * std::exp(-y * y / (2.0 * sigma * sigma));
      return slope * (x - shore + shore * std::tanh((x - shore) / fade));
    };
  };
  const Rectangle box{ { -50.0, -50.0 }, { 50.0, 50.0 } };
  expectDepth("bay", coast(0.08, -25.0, 16.0, 40.0), box);
  expectDepth("headland", coast(0.08, 25.0, 16.0, 40.0), box);
  const Depth turned = coast(0.05, -10.0, 12.0, 20.0);
  expectDepth(
    "bay:facing=0,slope=0.05,indent=10,sigma=12,fade=20", [&turned](double x, double y) { return turned(y, -x); }, box);
}

TEST(BuiltinSeafloor, bayAndHeadlandAreAHundredMetresSquareWithStraightWaterOffshore)
{
  for (const char* name : { "bay", "headland" })
  {
    const std::unique_ptr<Seafloor> bed = makeBuiltinSeafloor(name);
    const Rectangle box = bed->bounds();
    EXPECT_DOUBLE_EQ(box.size().x, 100.0) << name;
    EXPECT_DOUBLE_EQ(box.size().y, 100.0) << name;
    for (double y = box.low.y; y <= box.high.y; y += 1.0)
    {
      EXPECT_GT(-bed->elevation({ box.high.x, y }), 3.0) << name;
      EXPECT_GT(bed->elevation({ -25.5, y }), 0.0) << name;
    }
  }
}

TEST(BuiltinSeafloor, islands)
{
  const Rectangle box{ { -1500.0, -1400.0 }, { 1500.0, 1400.0 } };
  const auto cone = [](double slope, double shore, double toe)
  {
    return [=](double x, double y)
    {
      const double r = std::hypot(x, y);
      return slope * (std::clamp(r, 0.5 * shore, toe) - shore);
    };
  };
  const auto aboveTheCap = [&cone](double x, double y) { return cone(0.05, 200.0, 1000.0)(x, y); };
  const std::unique_ptr<Seafloor> bed = makeBuiltinSeafloor("island:kind=conical,s=0.05,rs=200,rt=1000");
  for (double r = 100.0; r < 1500.0; r += 7.3)
  {
    EXPECT_NEAR(-bed->elevation({ 0.6 * r, 0.8 * r }), aboveTheCap(0.6 * r, 0.8 * r), FormulaTolerance);
  }
  // The rounded summit lies below the cone's apex and above the ring where it joins.
  EXPECT_LT(bed->elevation({ 0.0, 0.0 }), 10.0);
  EXPECT_GT(bed->elevation({ 0.0, 0.0 }), 5.0);

  expectDepth(
    "island:kind=parabolic,h0=30,R=1200",
    [](double x, double y) { return 30.0 * std::min((x * x + y * y) / 1.44e6, 1.0); }, box);
}

TEST(BuiltinSeafloor, shoals)
{
  const Rectangle box{ { -1500.0, -1400.0 }, { 1500.0, 1400.0 } };
  expectDepth(
    "shoal:kind=gauss,h0=20,a=14,sigma=300",
    [](double x, double y) { return 20.0 - 14.0 * std::exp(-(x * x + y * y) / 180000.0); }, box);
  expectDepth("shoal:depth=60,height=50,sigma=1000,xc=5000,yc=5000,x0=0,y0=0,x1=10000,y1=10000",
    [](double x, double y) { return 60.0 - 50.0 * std::exp(-(std::pow(x - 5e3, 2) + std::pow(y - 5e3, 2)) / 2e6); },
    { { 0.0, 0.0 }, { 1e4, 1e4 } });
  expectDepth("shoal:kind=poly3,h0=15,a=10.5,R=250",
    [](double x, double y)
    {
      const double r = std::min(std::hypot(x, y) / 250.0, 1.0);
      return 15.0 - 10.5 * std::pow((1.0 - r) * (1.0 + r), 3);
    },
    { { -300.0, -300.0 }, { 300.0, 300.0 } });
}

TEST(BuiltinSeafloor, berkhoffShoal)
{
  const auto depth = [](double toe)
  {
    return [toe](double x, double y)
    {
      const double u = x * std::cos(radians(20.0)) - y * std::sin(radians(20.0));
      const double v = x * std::sin(radians(20.0)) + y * std::cos(radians(20.0));
      double h = u < -toe ? 0.45 : std::max(0.45 - 0.02 * (toe + u), 0.07);
      if (u * u / 9.0 + v * v / 16.0 < 1.0)
      {
        h += 0.3 - 0.5 * std::sqrt(1.0 - std::pow(u / 3.75, 2) - std::pow(v / 5.0, 2));
      }
      return h;
    };
  };
  const Rectangle box{ { -10.0, -10.0 }, { 15.0, 10.0 } };
  expectDepth("berkhoff", depth(5.82), box);
  expectDepth("berkhoff:toe=5.2", depth(5.2), box);
}

TEST(BuiltinSeafloor, vincentBriggsShoal)
{
  expectDepth("vincent-briggs",
    [](double x, double y)
    {
      // Inside x/3.05, y/3.96 in the paper's rounding; 3.81 x 0.8 = 3.048 is where the two depths meet.
      const bool inside = std::pow(x / 3.048, 2) + std::pow(y / 3.96, 2) <= 1.0;
      return inside ? 0.9144 - 0.762 * std::sqrt(1.0 - std::pow(x / 3.81, 2) - std::pow(y / 4.95, 2)) : 0.4572;
    },
    { { -6.0, -6.0 }, { 6.0, 6.0 } });
}

TEST(BuiltinSeafloor, babbageIsACoast)
{
  const std::unique_ptr<Seafloor> bed = makeBuiltinSeafloor("babbage");
  const Rectangle box = bed->bounds();
  EXPECT_DOUBLE_EQ(box.size().x, 1000.0);

  double meanNorth = 0.0;
  double highest = -1e9;
  double shoal = -1e9;
  for (double x = 2.5; x < 1000.0; x += 5.0)
  {
    meanNorth += -bed->elevation({ x, box.high.y }) / 200.0;
    EXPECT_GT(bed->elevation({ x, 0.0 }), 3.0) << "land all along the south edge";
    for (double y = 2.5; y < 800.0; y += 5.0)
    {
      const double z = bed->elevation({ x, y });
      highest = std::max(highest, z);
      if (std::hypot(x - 400.0, y - 590.0) < 120.0)
      {
        shoal = std::max(shoal, z);
      }
      // From the land down to the sea once: no ponds, no islets.
      if (z > 0.0)
      {
        EXPECT_GT(bed->elevation({ x, y - 5.0 }), 0.0) << "at " << x << ", " << y;
      }
    }
  }
  EXPECT_NEAR(meanNorth, 10.0, 0.1);
  EXPECT_GT(highest, 25.0);
  EXPECT_LT(highest, 35.0);
  EXPECT_GT(shoal, -4.0);
  EXPECT_LT(shoal, -3.0);

  const std::unique_ptr<Seafloor> deep = makeBuiltinSeafloor("babbage:offshore-depth=20");
  EXPECT_NEAR(deep->elevation({ 500.0, 800.0 }), 2.0 * bed->elevation({ 500.0, 800.0 }), 1e-6);
}

TEST(BuiltinSeafloor, registryIsCompleteAndDocumented)
{
  std::set<std::string> names;
  for (const FormDescription& form : builtinForms())
  {
    SCOPED_TRACE(form.name);
    EXPECT_TRUE(names.insert(form.name).second);
    EXPECT_FALSE(form.summary.empty());
    EXPECT_FALSE(form.formula.empty());
    EXPECT_GT(form.period, 0.0);
    EXPECT_GE(form.directionFrom, 0.0);
    EXPECT_LT(form.directionFrom, 360.0);
    std::set<std::string> keys;
    for (const FormKey& key : form.keys)
    {
      SCOPED_TRACE(key.name);
      EXPECT_TRUE(keys.insert(key.name).second);
      EXPECT_TRUE(key.symbol.empty() || keys.insert(key.symbol).second);
      EXPECT_FALSE(key.description.empty());
      EXPECT_FALSE(key.unit.empty());
      if (key.words.empty())
      {
        EXPECT_LT(key.low, key.high);
        EXPECT_LE(key.low, key.value);
        EXPECT_GE(key.high, key.value);
      }
    }
    for (const char* edge : { "x0", "y0", "x1", "y1" })
    {
      EXPECT_EQ(keys.count(edge), 1u);
    }
  }
  EXPECT_THAT(names,
    testing::UnorderedElementsAre(
      "plane", "dean", "bar", "bay", "headland", "island", "shoal", "berkhoff", "vincent-briggs", "babbage"));
}

TEST(BuiltinSeafloor, everyDefaultHasWaterWhereItsWavesComeFrom)
{
  for (const FormDescription& form : builtinForms())
  {
    SCOPED_TRACE(form.name);
    const std::unique_ptr<Seafloor> bed = makeBuiltinSeafloor(form.name);
    const Rectangle box = bed->bounds();
    for (const FormKey& key : form.keys)
    {
      const double bound = key.name == "x0" ? box.low.x
        : key.name == "y0"                  ? box.low.y
        : key.name == "x1"                  ? box.high.x
        : key.name == "y1"                  ? box.high.y
                                            : key.value;
      EXPECT_DOUBLE_EQ(bound, key.value) << key.name;
    }
    const double heading = headingFromNautical(form.directionFrom);
    const glm::dvec2 upwave = -glm::dvec2(std::cos(heading), std::sin(heading));
    const glm::dvec2 edge = 0.5 * (box.low + box.high) + 0.5 * upwave * box.size();
    EXPECT_LT(bed->elevation(edge), 0.0);
  }
}

TEST(BuiltinSeafloor, everyNumberIsUsedAtTheEndsOfItsRange)
{
  for (const FormDescription& form : builtinForms())
  {
    for (const FormKey& key : form.keys)
    {
      for (const double end : { key.low, key.high })
      {
        if (!key.words.empty() || key.name.find_first_of("01") != std::string::npos)
        {
          continue;
        }
        const std::string kind = key.kind.empty() ? "" : "kind=" + key.kind + ",";
        const std::string spec = form.name + ":" + kind + key.name + "=" + std::to_string(end);
        SCOPED_TRACE(spec);
        // Taken, or refused in words because it does not go with the other defaults; never a bed of NaN.
        try
        {
          const std::unique_ptr<Seafloor> bed = makeBuiltinSeafloor(spec);
          const Rectangle box = bed->bounds();
          for (int k = 0; k < 121; ++k)
          {
            const glm::dvec2 p = box.low + box.size() * glm::dvec2(k % 11 / 10.0, k / 11 / 10.0);
            const BedSample sample = bed->bed(p);
            ASSERT_TRUE(std::isfinite(sample.elevation) && std::isfinite(sample.gradient.x) &&
              std::isfinite(sample.gradient.y) && std::isfinite(sample.xx) && std::isfinite(sample.xy) &&
              std::isfinite(sample.yy))
              << "at " << p.x << ", " << p.y;
          }
        }
        catch (const std::invalid_argument& error)
        {
          EXPECT_THAT(error.what(), testing::HasSubstr("built-in seafloor '" + form.name + "'"));
        }
      }
    }
  }
}

TEST(BuiltinSeafloor, boundsAreSetByKeysAndTurnWithTheBeach)
{
  const Rectangle set = makeBuiltinSeafloor("shoal:x0=-50,y0=-40,x1=60,y1=+7e1")->bounds();
  EXPECT_EQ(set.low, glm::dvec2(-50.0, -40.0));
  EXPECT_EQ(set.high, glm::dvec2(60.0, 70.0));

  const Rectangle north = makeBuiltinSeafloor("plane:facing=0")->bounds();
  EXPECT_EQ(north.low, glm::dvec2(-1250.0, -100.0));
  EXPECT_EQ(north.high, glm::dvec2(1250.0, 2400.0));

  const Rectangle west = makeBuiltinSeafloor("plane:facing=270,x0=-900")->bounds();
  EXPECT_EQ(west.low, glm::dvec2(-900.0, -1250.0));
  EXPECT_EQ(west.high, glm::dvec2(100.0, 1250.0));
}

TEST(BuiltinSeafloor, knowsItsNames)
{
  EXPECT_TRUE(isBuiltinSeafloor("plane"));
  EXPECT_TRUE(isBuiltinSeafloor("plane:"));
  EXPECT_TRUE(isBuiltinSeafloor("vincent-briggs:x0=-9"));
  EXPECT_TRUE(isBuiltinSeafloor("plane:nonsense"));
  EXPECT_FALSE(isBuiltinSeafloor(""));
  EXPECT_FALSE(isBuiltinSeafloor("planes"));
  EXPECT_FALSE(isBuiltinSeafloor("plane.nc"));
  EXPECT_FALSE(isBuiltinSeafloor(":plane"));
  EXPECT_NO_THROW(makeBuiltinSeafloor("plane:"));
}

TEST(BuiltinSeafloor, isMeantByAMisspeltName)
{
  for (const char* meant : { "gaus", "berkoff:toe=5.82", "plnae", "iland", "vincent", "nothing:slope=1", "bay:" })
  {
    EXPECT_TRUE(resemblesBuiltinSeafloor(meant)) << meant;
  }
  for (const char* file : { "", "hawaii", "harbour", "gauss.tif", "./bay", "/data/plane", "Plane", "plane2",
         "NETCDF:\"x.nc\":z", "GPKG:a.gpkg:z" })
  {
    EXPECT_FALSE(resemblesBuiltinSeafloor(file)) << file;
  }
}

TEST(BuiltinSeafloor, wrongCallsAreToldInOneLine)
{
  const std::pair<const char*, const char*> wrong[] = {
    { "babage", "unknown built-in seafloor 'babage'; did you mean 'babbage'?" },
    { "berkoff:toe=1", "unknown built-in seafloor 'berkoff'; did you mean 'berkhoff'?" },
    { "vince", "did you mean 'vincent-briggs'?" },
    { "gaus", "did you mean 'shoal:kind=gauss'?" },
    { "conic:s=0.1", "did you mean 'island:kind=conical'?" },
    { "", "unknown built-in seafloor ''" },
    { "plane:slop=1", "unknown key 'slop'; did you mean 'slope'? Its keys: slope, offshore-depth, facing" },
    { "plane:=1", "unknown key ''" },
    { "plane:slope", "'slope' has no '='" },
    { "plane:slope=0.1,", "'' has no '='" },
    { "plane:,", "'' has no '='" },
    { "plane:slope=steep", "slope is 'steep', not a number" },
    { "plane:slope=", "slope is '', not a number" },
    { "plane:slope=0.1m", "slope is '0.1m', not a number" },
    { "plane:slope= 0.1", "not a number" },
    { "plane:slope=+-0.1", "not a number" },
    { "plane:slope=nan", "not a number" },
    { "plane:slope=inf", "not a number" },
    { "plane:slope=1e999", "not a number" },
    { "plane:slope=0", "slope is 0, out of range; allowed: 1e-06 to 10 m/m" },
    { "plane:slope=-0.02", "out of range" },
    { "plane:slope=0.1,slope=0.2", "'slope' is given twice" },
    { "plane:slope=0.1,s=0.2", "'slope' is given twice: 'slope=0.1' and 's=0.2'" },
    { "plane:facing=400", "facing is 400, out of range; allowed: -360 to 360 deg" },
    { "plane:x0=5000", "x0 must be below x1" },
    { "shoal:y0=10,y1=10", "y0 is 10 and y1 10; y0 must be below y1" },
    { "island:kind=square", "kind is 'square'; allowed: conical, parabolic" },
    { "island:kind=parabolic,slope=0.1", "kind=parabolic takes no 'slope'; it belongs to kind=conical" },
    { "shoal:radius=100", "kind=gauss takes no 'radius'" },
    { "island:toe-radius=100", "toe-radius is 100; it must be above shore-radius, 200 m" },
    { "dean:offshore-depth=0.01", "it must be above min-depth" },
    { "bar:offshore-depth=3", "it must be above slope x bar-position, 4 m" },
    { "bay:fade=20", "fade is 20; it must be above 25 m" },
    { "headland:reach=100,fade=40", "fade is 40; it must be above 44.6" },
    { "berkhoff:min-depth=0.5", "min-depth is 0.5; it must be below depth, 0.45 m" },
    { "babbage:x1=1200", "x1 is 1200, out of range; allowed: 0 to 1000 m" },
  };
  for (const auto& [spec, message] : wrong)
  {
    const std::string error = errorOf(spec);
    EXPECT_THAT(error, testing::HasSubstr(message)) << spec;
    EXPECT_EQ(error.find('\n'), std::string::npos) << spec;
  }
}

}
