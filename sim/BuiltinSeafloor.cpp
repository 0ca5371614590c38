#include "sim/BuiltinSeafloor.h"

#include "sim/forms/BabbageBeach.h"
#include "sim/forms/BarBeach.h"
#include "sim/forms/ConicalIsland.h"
#include "sim/forms/CurvedCoast.h"
#include "sim/forms/DeanBeach.h"
#include "sim/forms/EllipsoidShoal.h"
#include "sim/forms/FormCatalogue.h"
#include "sim/forms/FormKeys.h"
#include "sim/forms/GaussianShoal.h"
#include "sim/forms/ParabolicIsland.h"
#include "sim/forms/PlaneBeach.h"
#include "sim/forms/PolynomialShoal.h"

namespace swellray
{

namespace
{

using namespace formkeys;
using Form = FormCatalogue<Seafloor>::Form;

constexpr double LargestDepth = 2e4; // m

FormKey onlyFor(const std::string& kind, FormKey key)
{
  key.kind = kind;
  return key;
}

FormKey depth(const std::string& name, const std::string& symbol, double value, const std::string& description)
{
  return number(name, symbol, "m", value, SmallestLength, LargestDepth, description);
}

FormKey slope(double value)
{
  return number("slope", "s", "m/m", value, 1e-6, 10.0, "slope of the bed");
}

FormKey kind(const std::vector<std::string>& words)
{
  FormKey key;
  key.name = "kind";
  key.unit = "-";
  key.description = "shape";
  key.words = words;
  return key;
}

FormKey facing()
{
  return number("facing", "", "deg", 90.0, -360.0, 360.0,
    "nautical direction that the beach faces, seaward; default bounds turn with it");
}

FormKey offshoreFloor()
{
  return number(
    "offshore-depth", "", "m", 0.0, 0.0, LargestDepth, "depth where the slope ends at a flat floor; 0: it goes on");
}

std::vector<FormKey> centre()
{
  return { position("xc", 0.0, "centre, east"), position("yc", 0.0, "centre, north") };
}

std::vector<FormKey> edges(const Rectangle& box)
{
  return { position("x0", box.low.x, "west edge of the scene"), position("y0", box.low.y, "south edge of the scene"),
    position("x1", box.high.x, "east edge of the scene"), position("y1", box.high.y, "north edge of the scene") };
}

std::vector<FormKey> with(std::vector<FormKey> keys, const std::vector<FormKey>& more)
{
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

const Rectangle BeachScene{ { -100.0, -1250.0 }, { 2400.0, 1250.0 } };
const Rectangle IslandScene{ { -1800.0, -1800.0 }, { 1800.0, 1800.0 } };

Form planeForm()
{
  return { { "plane", "plane beach", "h = s x", "", with({ slope(0.02), offshoreFloor(), facing() }, edges(BeachScene)),
             90.0, 10.0 },
    [](const FormValues& v) -> std::unique_ptr<Seafloor>
    { return std::make_unique<PlaneBeach>(v.boundsFacing(), v["facing"], v["slope"], v["offshore-depth"]); } };
}

Form deanForm()
{
  return { { "dean", "equilibrium beach", "h = A x^(2/3); a finite slope where h < min-depth", "Bruun 1954; Dean 1977",
             with({ number("scale", "A", "m^(1/3)", 0.12, 1e-4, 10.0, "profile scale, of the grain size"),
                    number("min-depth", "", "m", 0.05, 1e-4, 10.0, "depth down to which the formula holds"),
                    offshoreFloor(), facing() },
               edges(BeachScene)),
             90.0, 9.0 },
    [](const FormValues& v) -> std::unique_ptr<Seafloor>
    {
      const double floor = v["offshore-depth"];
      if (floor > 0.0 && floor <= v["min-depth"])
      {
        v.fail("offshore-depth is " + formatNumber(floor) + "; it must be above min-depth, " +
          formatNumber(v["min-depth"]) + " m");
      }
      return std::make_unique<DeanBeach>(v.boundsFacing(), v["facing"], v["scale"], v["min-depth"], floor);
    } };
}

Form barForm()
{
  return {
    { "bar", "plane beach with a longshore bar", "h = s x - hb exp(-((x - xb)/wb)^2)", "",
      with({ slope(0.02), number("bar-height", "hb", "m", 2.0, 0.0, LargestDepth, "height of the bar above the slope"),
             length("bar-position", "xb", 200.0, "distance of its crest from the shoreline"),
             length("bar-width", "wb", 40.0, "its half width at 1/e of its height"), offshoreFloor(), facing() },
        edges(BeachScene)),
      90.0, 9.0 },
    [](const FormValues& v) -> std::unique_ptr<Seafloor>
    {
      const double floor = v["offshore-depth"];
      const double atBar = v["slope"] * v["bar-position"];
      if (floor > 0.0 && floor <= atBar)
      {
        v.fail("offshore-depth is " + formatNumber(floor) + "; it must be above slope x bar-position, " +
          formatNumber(atBar) + " m, so that the bar lies on the slope");
      }
      return std::make_unique<BarBeach>(v.boundsFacing(), v["facing"], v["slope"],
        BarBeach::Bar{ v["bar-height"], v["bar-position"], v["bar-width"] }, floor);
    }
  };
}

std::unique_ptr<Seafloor> makeCoast(const FormValues& v, double reach, double farthestLandward)
{
  if (v["fade"] <= farthestLandward)
  {
    v.fail("fade is " + formatNumber(v["fade"]) + "; it must be above " + formatNumber(farthestLandward) +
      " m, or the bed falls landward in the bay");
  }
  return std::make_unique<CurvedCoast>(
    v.boundsFacing(), v["facing"], CurvedCoast::Shape{ v["slope"], reach, v["sigma"], v["fade"] });
}

Form bayForm()
{
  return { { "bay", "bay between two capes",
             "h = s (d + xs tanh(d/e)), d = x - xs(y), xs = -a (1 - t^2) exp(-t^2/2), t = y/w", "",
             with({ slope(0.08), length("indent", "a", 25.0, "how far the bay cuts into the land"),
                    length("sigma", "w", 16.0, "half width of the bay along the shore"),
                    length("fade", "e", 40.0, "distance offshore over which the contours straighten"), facing() },
               edges({ { -35.0, -50.0 }, { 65.0, 50.0 } })),
             90.0, 3.0 },
    [](const FormValues& v) { return makeCoast(v, -v["indent"], v["indent"]); } };
}

Form headlandForm()
{
  return { { "headland", "headland between two coves",
             "h = s (d + xs tanh(d/e)), d = x - xs(y), xs = a (1 - t^2) exp(-t^2/2), t = y/w", "",
             with({ slope(0.08), length("reach", "a", 25.0, "how far the headland stands out"),
                    length("sigma", "w", 16.0, "its half width along the shore"),
                    length("fade", "e", 40.0, "distance offshore over which the contours straighten"), facing() },
               edges({ { -20.0, -50.0 }, { 80.0, 50.0 } })),
             90.0, 3.0 },
    [](const FormValues& v) { return makeCoast(v, v["reach"], CurvedCoast::coveShare() * v["reach"]); } };
}

Form islandForm()
{
  return { { "island", "circular island, r from its centre",
             "conical: h = s (r - rs) for r < rt; parabolic: h = h0 (r/R)^2 for r < R; flat beyond", "",
             with({ kind({ "conical", "parabolic" }), onlyFor("conical", slope(0.05)),
                    onlyFor("conical", length("shore-radius", "rs", 200.0, "radius of the shoreline")),
                    onlyFor("conical", length("toe-radius", "rt", 1000.0, "radius where the slope ends")),
                    onlyFor("parabolic", depth("depth", "h0", 30.0, "depth around the island")),
                    onlyFor("parabolic", length("radius", "R", 1200.0, "radius where the slope ends")) },
               with(centre(), edges(IslandScene))),
             270.0, 12.0 },
    [](const FormValues& v) -> std::unique_ptr<Seafloor>
    {
      const glm::dvec2 middle(v["xc"], v["yc"]);
      if (v.word("kind") == "parabolic")
      {
        return std::make_unique<ParabolicIsland>(v.bounds(), middle, v["depth"], v["radius"]);
      }
      if (v["toe-radius"] <= v["shore-radius"])
      {
        v.fail("toe-radius is " + formatNumber(v["toe-radius"]) + "; it must be above shore-radius, " +
          formatNumber(v["shore-radius"]) + " m");
      }
      return std::make_unique<ConicalIsland>(v.bounds(), middle, v["slope"], v["shore-radius"], v["toe-radius"]);
    } };
}

Form shoalForm()
{
  return { { "shoal", "circular shoal on a flat floor, r from its centre",
             "gauss: h = h0 - a exp(-r^2/(2 sigma^2)); poly3: h = h0 - a (1 - (r/R)^2)^3 for r < R, h0 beyond", "",
             with({ kind({ "gauss", "poly3" }), depth("depth", "h0", 20.0, "depth around the shoal"),
                    number("height", "a", "m", 14.0, 0.0, LargestDepth, "height of the shoal above the floor"),
                    onlyFor("gauss", length("sigma", "sg", 300.0, "its standard deviation")),
                    onlyFor("poly3", length("radius", "R", 750.0, "radius of its rim")) },
               with(centre(), edges(IslandScene))),
             270.0, 10.0 },
    [](const FormValues& v) -> std::unique_ptr<Seafloor>
    {
      const glm::dvec2 middle(v["xc"], v["yc"]);
      if (v.word("kind") == "poly3")
      {
        return std::make_unique<PolynomialShoal>(v.bounds(), middle, v["depth"], v["height"], v["radius"]);
      }
      return std::make_unique<GaussianShoal>(v.bounds(), middle, v["depth"], v["height"], v["sigma"]);
    } };
}

Form berkhoffForm()
{
  return { { "berkhoff", "elliptic shoal on a slope, its centre at 0, 0",
             "h = max(h0 - s (u + toe), min-depth) for u > -toe, h0 before; less 0.5 sqrt(1 - (u/3.75)^2 - (v/5)^2) - "
             "0.3 inside (u/3)^2 + (v/4)^2 = 1; u = x cos - y sin, v = x sin + y cos of the rotation",
             "Berkhoff, Booij and Radder 1982",
             with(
               { depth("depth", "h0", 0.45, "depth before the slope"), slope(0.02),
                 number("toe", "", "m", 5.82, 0.0, 1e3, "distance from the toe of the slope to the shoal's centre"),
                 number("min-depth", "", "m", 0.07, 0.0, LargestDepth,
                   "depth where the slope ends at a flat floor; 0: it goes on above water"),
                 number("rotation", "", "deg", 20.0, -360.0, 360.0, "clockwise angle from the x axis to the slope's") },
               edges({ { -10.0, -10.0 }, { 12.0, 10.0 } })),
             270.0, 1.0 },
    [](const FormValues& v) -> std::unique_ptr<Seafloor>
    {
      if (v["min-depth"] >= v["depth"])
      {
        v.fail("min-depth is " + formatNumber(v["min-depth"]) + "; it must be below depth, " +
          formatNumber(v["depth"]) + " m");
      }
      return std::make_unique<EllipsoidShoal>(v.bounds(),
        EllipsoidShoal::Floor{ v["depth"], v["slope"], v["toe"], v["min-depth"], radians(v["rotation"]) },
        EllipsoidShoal::Ellipsoid{ 0.5, 0.3, { 3.75, 5.0 } });
    } };
}

Form vincentBriggsForm()
{
  return { { "vincent-briggs", "elliptic shoal on a flat floor, its centre at 0, 0",
             "h = 0.4572; 0.9144 - 0.762 sqrt(1 - (x/3.81)^2 - (y/4.95)^2) inside the ellipse where both meet, "
             "(x/3.048)^2 + (y/3.96)^2 = 1",
             "Vincent and Briggs 1989", edges({ { -6.0, -12.0 }, { 16.0, 12.0 } }), 270.0, 1.3 },
    [](const FormValues& v) -> std::unique_ptr<Seafloor>
    {
      return std::make_unique<EllipsoidShoal>(v.bounds(), EllipsoidShoal::Floor{ 0.4572, 0.0, 0.0, 0.0, 0.0 },
        EllipsoidShoal::Ellipsoid{ 0.762, 0.9144 - 0.4572, { 3.81, 4.95 } });
    } };
}

Form babbageForm()
{
  const Rectangle extent = BabbageBeach::extent();
  std::vector<FormKey> sides = edges(extent);
  for (FormKey& side : sides)
  {
    const bool alongX = side.name.front() == 'x';
    side.low = alongX ? extent.low.x : extent.low.y;
    side.high = alongX ? extent.high.x : extent.high.y;
  }
  return { { "babbage", "1 km beach facing north with cliffs, a headland and an offshore shoal",
             "a coarse table of elevations refined by a spline", "after the Babbage Beach of Peachey 1986",
             with({ number("offshore-depth", "", "m", BabbageBeach::offshoreDepth(), 1.0, 1000.0,
                    "mean depth along the seaward edge; all depths scale with it") },
               sides),
             0.0, 6.0 },
    [](const FormValues& v) -> std::unique_ptr<Seafloor>
    { return std::make_unique<BabbageBeach>(v.bounds(), v["offshore-depth"]); } };
}

const FormCatalogue<Seafloor>& catalogue()
{
  static const FormCatalogue<Seafloor> all("seafloor",
    { planeForm(), deanForm(), barForm(), bayForm(), headlandForm(), islandForm(), shoalForm(), berkhoffForm(),
      vincentBriggsForm(), babbageForm() });
  return all;
}

}

const std::vector<FormDescription>& builtinForms()
{
  return catalogue().descriptions();
}

bool isBuiltinSeafloor(const std::string& spec)
{
  return catalogue().has(spec);
}

bool resemblesBuiltinSeafloor(const std::string& spec)
{
  return catalogue().resembles(spec);
}

std::unique_ptr<Seafloor> makeBuiltinSeafloor(const std::string& spec)
{
  return catalogue().make(spec);
}

}
