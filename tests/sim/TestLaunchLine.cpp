// The incident wave on the edges of a scene: exact on straight beaches that face anywhere, on their side edges too.
#include "RayComparison.h"

#include "sim/BuiltinSeafloor.h"
#include "sim/LaunchLine.h"
#include "sim/SplineSeafloor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

using namespace swellray;
using namespace swellray::reference;

namespace
{

constexpr double Aground = 0.05; // m

// Rounding of the wavenumber and of the plane fitted to the bed.
constexpr double Rounding = 1e-12;

// Integration along the edges, over depths from the shore to the deep: rounding of some thousand parts.
constexpr double IntegralTolerance = 1e-11; // relative to the size of the scene

struct ObliqueCase
{
  const char* name;
  double facing;
  double slope;
  double period;
  double from; // nautical degrees
  double offshoreDepth;
};

constexpr double Deep = std::numeric_limits<double>::infinity();

const ObliqueCase Cases[] = { { "EastNormal", 90.0, 0.02, 10.0, 90.0, Deep },
  { "EastFromSouth", 90.0, 0.02, 10.0, 130.0, Deep }, { "EastFromNorth", 90.0, 0.015, 12.0, 35.0, Deep },
  { "NorthEast", 30.0, 0.03, 8.0, 75.0, Deep }, { "NorthEastOther", 30.0, 0.02, 10.0, -20.0, Deep },
  { "SouthWest", 200.0, 0.02, 14.0, 170.0, Deep }, { "SouthWestFinite", 200.0, 0.02, 14.0, 250.0, 60.0 },
  { "West", 270.0, 0.05, 6.0, 300.0, Deep } };

void PrintTo(const ObliqueCase& c, std::ostream* out)
{
  *out << c.name;
}

/** The wave over the whole of a straight beach h = s u, its shoreline through the origin. */
class BeachWave
{
public:
  explicit BeachWave(const ObliqueCase& c)
    : Slope(c.slope)
    , Omega(2.0L * reference::Pi / c.period)
  {
    // From the definition: the normal points away from where the beach faces, the wave goes away from where it is from.
    const double landward = radians(270.0 - c.facing);
    const double heading = radians(270.0 - c.from);
    this->Normal = { std::cos(landward), std::sin(landward) };
    this->Tangent = { -this->Normal.y, this->Normal.x };
    const Real k0 = c.offshoreDepth < Deep ? wavenumber(this->Omega, c.offshoreDepth)
                                           : this->Omega * this->Omega / reference::Gravity;
    this->Along = static_cast<double>(k0 * std::sin(static_cast<Real>(heading - landward)));
    this->Cosine0 = std::cos(heading - landward);
    const double theta = std::asin(this->Along / static_cast<double>(wavenumber(this->Omega, c.slope * Far)));
    this->Ray = std::make_unique<StraightRay>(
      [s = this->Slope](Real u) { return s * u; }, static_cast<double>(this->Omega), Far, theta);
  }

  double along() const { return this->Along; }
  double cosine0() const { return this->Cosine0; }
  const glm::dvec2& normal() const { return this->Normal; }
  const glm::dvec2& tangent() const { return this->Tangent; }

  double distance(const glm::dvec2& p) const { return -glm::dot(this->Normal, p); }

  double wavenumberAt(const glm::dvec2& p) const
  {
    return static_cast<double>(wavenumber(this->Omega, this->Slope * this->distance(p)));
  }

  /** Cosine of the wave's angle to the normal. */
  double cosine(const glm::dvec2& p) const
  {
    const double sine = this->Along / this->wavenumberAt(p);
    return std::sqrt(1.0 - sine * sine);
  }

  /** Place along the incident crest of the ray through p, m, but for a constant. */
  double crest(const glm::dvec2& p) const
  {
    return this->Cosine0 * (glm::dot(this->Tangent, p) - this->Ray->at(this->distance(p)).y);
  }

  /** Phase, but for a constant: K v + int kn du, kn = k^2/kn - K^2/kn. */
  double phase(const glm::dvec2& p) const
  {
    const Place place = this->Ray->at(this->distance(p));
    return this->Along * (glm::dot(this->Tangent, p) - place.y) + place.phase;
  }

private:
  static constexpr double Far = 4000.0; // beyond all scenes, m

  double Slope;
  Real Omega;
  glm::dvec2 Normal{ 0.0 };
  glm::dvec2 Tangent{ 0.0 };
  double Along = 0.0;
  double Cosine0 = 1.0;
  std::unique_ptr<StraightRay> Ray;
};

IncidentWave waveOf(const ObliqueCase& c)
{
  IncidentWave wave;
  wave.period = c.period;
  wave.directionFrom = c.from;
  wave.offshoreDepth = c.offshoreDepth;
  return wave;
}

std::unique_ptr<Seafloor> beachOf(const ObliqueCase& c)
{
  return makeBuiltinSeafloor("plane:facing=" + std::to_string(c.facing) + ",s=" + std::to_string(c.slope));
}

bool onEdge(const Rectangle& box, const glm::dvec2& p)
{
  const double rounding = 1e-9;
  const auto at = [rounding](double a, double b) { return std::abs(a - b) < rounding; };
  const bool inside = p.x > box.low.x - rounding && p.x < box.high.x + rounding && p.y > box.low.y - rounding &&
    p.y < box.high.y + rounding;
  return inside && (at(p.x, box.low.x) || at(p.x, box.high.x) || at(p.y, box.low.y) || at(p.y, box.high.y));
}

class ObliqueWave : public testing::TestWithParam<ObliqueCase>
{
};

double crossLeft(const glm::dvec2& direction, const glm::dvec2& v)
{
  return (direction.x * v.y - direction.y * v.x) / glm::length(direction);
}

}

TEST_P(ObliqueWave, isThatOfTheStraightBeachOnEveryEdge)
{
  const ObliqueCase& c = GetParam();
  const auto beach = beachOf(c);
  const LaunchLine line(*beach, 0.0, waveOf(c), Aground, { EdgeRule::Contours });
  const BeachWave exact(c);
  ASSERT_TRUE(line.contourNormal());
  EXPECT_LT(glm::length(*line.contourNormal() - exact.normal()), Rounding);
  ASSERT_GT(line.length(), 0.0);

  constexpr int count = 400;
  std::vector<double> phases;
  int segment = -1;
  double crestOffset = 0.0;
  double phaseOffset = 0.0;
  for (int i = 0; i <= count; ++i)
  {
    const double lambda = line.length() * i / count;
    const LaunchPoint point = line.at(lambda);
    ASSERT_TRUE(onEdge(beach->bounds(), point.position)) << lambda;
    const double depth = -beach->elevation(point.position);
    EXPECT_GT(depth, Aground - 1e-9);

    const double k = exact.wavenumberAt(point.position);
    EXPECT_NEAR(glm::length(point.wavenumber) / k, 1.0, Rounding);
    EXPECT_NEAR(glm::dot(point.wavenumber, exact.tangent()) / k, exact.along() / k, Rounding);
    EXPECT_GT(glm::dot(point.wavenumber, exact.normal()), 0.0);
    EXPECT_NEAR(glm::dot(point.dWavenumber, exact.tangent()), 0.0, Rounding * (k + glm::length(point.dWavenumber)));

    const double ratio = exact.cosine(point.position) / exact.cosine0();
    EXPECT_NEAR(crossLeft(point.wavenumber, point.dPosition) / ratio, 1.0, Rounding) << lambda;

    // Equal steps of lambda are equal steps along the crest offshore, and the phase is one function for all edges. On
    // an edge nearly along the rays these may leave offshore and come in again near the shore: a segment of its own.
    if (point.segment != segment)
    {
      segment = point.segment;
      crestOffset = exact.crest(point.position) - lambda;
      phaseOffset = i == 0 ? exact.phase(point.position) - point.phase : phaseOffset;
    }
    const double size = glm::length(beach->bounds().size());
    EXPECT_NEAR(exact.crest(point.position) - lambda, crestOffset, IntegralTolerance * size) << lambda;
    EXPECT_NEAR(exact.phase(point.position) - point.phase, phaseOffset, IntegralTolerance * size * k) << lambda;
    phases.push_back(point.phase);
  }
  // 0 where the wave meets the scene first.
  const double earliest = *std::min_element(phases.begin(), phases.end());
  EXPECT_GE(earliest, -1e-9);
  EXPECT_LT(earliest, 0.5);
}

TEST_P(ObliqueWave, changesAlongTheEdgeAsItsDerivativesSay)
{
  const ObliqueCase& c = GetParam();
  const auto beach = beachOf(c);
  const LaunchLine line(*beach, 0.0, waveOf(c), Aground, { EdgeRule::Contours });
  // Central differences; the tolerance is that of their truncation and of the integration along the edge.
  constexpr double apart = 0.05;
  constexpr double tolerance = 1e-5;
  int compared = 0;
  for (int i = 1; i < 100; ++i)
  {
    const double lambda = line.length() * i / 100.0;
    const LaunchPoint before = line.at(lambda - apart);
    const LaunchPoint point = line.at(lambda);
    const LaunchPoint after = line.at(lambda + apart);
    const glm::dvec2 bend = after.position - 2.0 * point.position + before.position;
    if (glm::length(bend) > 1e-3 * apart || -beach->elevation(point.position) < 1.0)
    {
      continue; // around a corner, or near the shore, where all changes fast
    }
    ++compared;
    EXPECT_LT(glm::length((after.position - before.position) / (2.0 * apart) - point.dPosition),
      tolerance * glm::length(point.dPosition));
    EXPECT_LT(glm::length((after.wavenumber - before.wavenumber) / (2.0 * apart) - point.dWavenumber),
      tolerance * (glm::length(point.dWavenumber) + 1e-6));
  }
  EXPECT_GT(compared, 60);
}

TEST_P(ObliqueWave, sendsRaysThatKeepToTheExactOnes)
{
  const ObliqueCase& c = GetParam();
  const auto beach = beachOf(c);
  const LaunchLine line(*beach, 0.0, waveOf(c), Aground, { EdgeRule::Contours });
  const BeachWave exact(c);
  const RayMedium medium = mediumOf(*beach, c.period, Aground);
  // Tolerance 1e-12 on some km of rays: see the comparisons on straight contours.
  constexpr double rayTolerance = 1e-12;
  constexpr double positionTolerance = 3e-9;
  constexpr double widthTolerance = 1e-9;
  int traced = 0;
  for (int i = 0; i < 40; ++i)
  {
    const LaunchPoint launch = line.at(line.length() * (i + 0.5) / 40.0);
    RayStart start;
    start.position = launch.position;
    start.wavenumber = launch.wavenumber;
    start.dPosition = launch.dPosition;
    start.dWavenumber = launch.dWavenumber;
    start.phase = launch.phase;
    HamiltonianRay ray(medium, start, rayTolerance);
    const double crest = exact.crest(launch.position);
    const double offset = exact.phase(launch.position) - launch.phase;
    RayPoint point;
    while (ray.advance(FrontMeasure::Length, ray.length() + 150.0, point))
    {
      EXPECT_NEAR(exact.crest(point.position), crest, positionTolerance);
      EXPECT_NEAR(exact.phase(point.position) - point.phase, offset, 1e-9);
      const double ratio = exact.cosine(point.position) / exact.cosine0();
      EXPECT_NEAR(point.tubeWidth / ratio, 1.0, widthTolerance);
      EXPECT_EQ(point.caustics, 0);
      ++traced;
    }
    EXPECT_TRUE(ray.endReason() == EndReason::Aground || ray.endReason() == EndReason::LeftScene);
  }
  EXPECT_GT(traced, 100);
}

INSTANTIATE_TEST_SUITE_P(LaunchLine, ObliqueWave, testing::ValuesIn(Cases),
  [](const testing::TestParamInfo<ObliqueCase>& c) { return std::string(c.param.name); });

TEST(LaunchLine, isAsLongAsTheCrestThatComesIn)
{
  // A beach that faces east, the wave from the north-east: in through the north edge, from where it is wet, and the east.
  const ObliqueCase c{ "", 90.0, 0.02, 10.0, 40.0, Deep };
  const auto beach = beachOf(c);
  const LaunchLine line(*beach, 0.0, waveOf(c), Aground, { EdgeRule::Contours });
  const Rectangle box = beach->bounds();
  const BeachWave exact(c);
  const glm::dvec2 shore(Aground / c.slope, box.high.y);
  const glm::dvec2 corner(box.high.x, box.low.y);
  // The rays go south-west: their left is south-east, where lambda grows to.
  EXPECT_LT(glm::length(line.at(0.0).position - shore), 1e-6);
  EXPECT_LT(glm::length(line.at(line.length()).position - corner), 1e-6);
  EXPECT_NEAR(line.length(), exact.crest(corner) - exact.crest(shore), 1e-6);
  // Of that, through the east edge comes its projection on the crest offshore.
  const double east = std::abs(std::cos(radians(50.0))) * box.size().y;
  EXPECT_LT(glm::length(line.at(line.length() - east).position - box.high), 1e-6);
}

TEST(LaunchLine, takesTheDirectionAsGivenWithoutARule)
{
  const ObliqueCase c{ "", 90.0, 0.02, 10.0, 120.0, Deep };
  const auto beach = beachOf(c);
  const LaunchLine line(*beach, 0.0, waveOf(c), Aground, { EdgeRule::None });
  EXPECT_FALSE(line.contourNormal());
  const Rectangle box = beach->bounds();
  // The shadow of the box on the crest: the wet part of the south edge and the east edge.
  const glm::dvec2 t(std::cos(radians(150.0)), std::sin(radians(150.0)));
  const double wet = box.high.x - Aground / c.slope;
  EXPECT_NEAR(line.length(), wet * t.y - box.size().y * t.x, 1e-7);
  for (int i = 0; i <= 50; ++i)
  {
    const LaunchPoint point = line.at(line.length() * i / 50.0);
    const double k =
      static_cast<double>(wavenumber(2.0L * reference::Pi / c.period, -beach->elevation(point.position)));
    EXPECT_LT(glm::length(point.wavenumber - k * t), Rounding * k);
    EXPECT_NEAR(crossLeft(t, point.dPosition), 1.0, Rounding);
    const double slope = static_cast<double>(
      wavenumberSlope(2.0L * reference::Pi / c.period, -beach->elevation(point.position)) * c.slope);
    EXPECT_LT(glm::length(point.dWavenumber - slope * point.dPosition.x * t), Rounding * (k + std::abs(slope)));
  }
}

TEST(LaunchLine, keepsTheWavenumberAlongEachEdgeByTheEdgeRule)
{
  const ObliqueCase c{ "", 90.0, 0.02, 10.0, 120.0, Deep };
  const auto beach = beachOf(c);
  const LaunchLine line(*beach, 0.0, waveOf(c), Aground, { EdgeRule::Edge });
  const Rectangle box = beach->bounds();
  const IncidentWave wave = waveOf(c);
  const double k0 = static_cast<double>(4.0L * reference::Pi * reference::Pi / (c.period * c.period * Gravity));
  const glm::dvec2 t0 = wave.direction();
  int south = 0;
  int east = 0;
  for (int i = 0; i <= 100; ++i)
  {
    const LaunchPoint point = line.at(line.length() * i / 100.0);
    const bool isSouth = std::abs(point.position.y - box.low.y) < 1e-9;
    const glm::dvec2 along = isSouth ? glm::dvec2(1.0, 0.0) : glm::dvec2(0.0, 1.0);
    const glm::dvec2 inward = isSouth ? glm::dvec2(0.0, 1.0) : glm::dvec2(-1.0, 0.0);
    (isSouth ? south : east) += 1;
    const double k =
      static_cast<double>(wavenumber(2.0L * reference::Pi / c.period, -beach->elevation(point.position)));
    EXPECT_NEAR(glm::length(point.wavenumber), k, Rounding * k);
    EXPECT_NEAR(glm::dot(point.wavenumber, along), k0 * glm::dot(t0, along), Rounding * k);
    const double cosine = glm::dot(point.wavenumber, inward) / k;
    EXPECT_GT(cosine, 0.0);
    EXPECT_NEAR(crossLeft(point.wavenumber, point.dPosition) / (cosine / glm::dot(t0, inward)), 1.0, 10.0 * Rounding);
  }
  EXPECT_GT(south, 10);
  EXPECT_GT(east, 10);
  // Each edge carries its projection on the crest offshore.
  const double wet = box.high.x - Aground / c.slope;
  EXPECT_NEAR(line.length(), wet * t0.y - box.size().y * t0.x, 1e-6);
}

TEST(LaunchLine, takesANormalThatIsGiven)
{
  const ObliqueCase c{ "", 90.0, 0.02, 10.0, 120.0, Deep };
  const auto beach = beachOf(c);
  const LaunchLine line(*beach, 0.0, waveOf(c), Aground, { EdgeRule::Contours, 110.0 });
  ASSERT_TRUE(line.contourNormal());
  const double landward = radians(270.0 - 110.0);
  EXPECT_LT(glm::length(*line.contourNormal() - glm::dvec2(std::cos(landward), std::sin(landward))), Rounding);
  // 10 degrees from that normal: its wavenumber along the contours is kept.
  const glm::dvec2 tangent(-std::sin(landward), std::cos(landward));
  const double k0 = static_cast<double>(4.0L * reference::Pi * reference::Pi / (c.period * c.period * Gravity));
  const LaunchPoint point = line.at(0.3 * line.length());
  EXPECT_NEAR(glm::dot(point.wavenumber, tangent), k0 * std::sin(radians(-10.0)), Rounding);
}

TEST(LaunchLine, takesTheDirectionAsGivenOverAFlatBed)
{
  const auto flat = makeBuiltinSeafloor("shoal:a=0,h0=15");
  IncidentWave wave;
  wave.directionFrom = 250.0;
  const LaunchLine line(*flat, 0.0, wave, Aground, { EdgeRule::Contours });
  EXPECT_FALSE(line.contourNormal());
  const glm::dvec2 size = flat->bounds().size();
  const glm::dvec2 t = wave.direction();
  EXPECT_NEAR(line.length(), size.y * std::abs(t.x) + size.x * std::abs(t.y), 1e-8);
  // The phase is k.x of the plane wave, and 0 at the corner it meets first.
  const double k = static_cast<double>(wavenumber(wave.angularFrequency(), 15.0L));
  const glm::dvec2 corner = flat->bounds().low;
  for (int i = 0; i <= 20; ++i)
  {
    const LaunchPoint point = line.at(line.length() * i / 20.0);
    EXPECT_NEAR(point.phase, k * glm::dot(t, point.position - corner), 1e-9);
    EXPECT_NEAR(crossLeft(t, point.dPosition), 1.0, Rounding);
    EXPECT_EQ(point.dWavenumber, glm::dvec2(0.0));
  }
}

TEST(LaunchLine, isSplitByLandOnTheEdge)
{
  // A ridge from west to east: dry on the edge where 20 - 40 exp(-(y/100)^2) < Aground.
  Formula formula;
  formula.depth = [](const Jet&, const Jet& y, unsigned) { return Jet(20.0) - 40.0 * exp(-(y * y) / (100.0 * 100.0)); };
  const FormulaSeafloor ridge(formula, { { -500.0, -800.0 }, { 500.0, 700.0 } }, 50.0);
  IncidentWave wave;
  wave.directionFrom = 90.0;
  const LaunchLine line(ridge, 0.0, wave, Aground, { EdgeRule::None });
  const double dry = 100.0 * std::sqrt(std::log(40.0 / (20.0 - Aground)));
  EXPECT_NEAR(line.length(), 1500.0 - 2.0 * dry, 1e-8);
  // Rays go west, lambda grows to the south.
  double last = 1e9;
  const double north = 700.0 - dry;
  for (int i = 0; i <= 300; ++i)
  {
    const double lambda = line.length() * i / 300.0;
    const LaunchPoint point = line.at(lambda);
    EXPECT_DOUBLE_EQ(point.position.x, 500.0);
    EXPECT_LT(point.position.y, last);
    last = point.position.y;
    EXPECT_EQ(point.segment, lambda < north ? 0 : 1);
    EXPECT_NEAR(point.position.y, lambda < north ? 700.0 - lambda : -dry - (lambda - north), 1e-8);
  }
}

TEST(LaunchLine, isSplitByAHoleOnTheEdge)
{
  // An inlet of no data that does not bend the outline of what there is.
  ElevationGrid grid;
  grid.columns = 51;
  grid.rows = 61;
  grid.spacing = { 10.0, 10.0 };
  grid.elevation.assign(grid.columns * grid.rows, -12.0);
  for (std::size_t j = 20; j <= 25; ++j)
  {
    grid.at(0, j) = std::numeric_limits<double>::quiet_NaN();
  }
  const SplineSeafloor seafloor(grid);
  IncidentWave wave;
  wave.directionFrom = 270.0;
  const LaunchLine line(seafloor, 0.0, wave, Aground, { EdgeRule::None });
  // Cells that touch a node without data are a hole: rows 19 to 26.
  EXPECT_NEAR(line.length(), 600.0 - 70.0, 1e-6);
  EXPECT_EQ(line.at(0.0).segment, 0);
  EXPECT_EQ(line.at(line.length()).segment, 1);
}

TEST(LaunchLine, hasNoLengthWhereNothingComesIn)
{
  Formula land;
  land.depth = [](const Jet&, const Jet&, unsigned) { return Jet(-3.0); };
  const FormulaSeafloor dry(land, { { 0.0, 0.0 }, { 100.0, 100.0 } }, 10.0);
  for (const EdgeRule rule : { EdgeRule::Contours, EdgeRule::Edge, EdgeRule::None })
  {
    const LaunchLine line(dry, 0.0, IncidentWave(), Aground, { rule });
    EXPECT_EQ(line.length(), 0.0);
    EXPECT_THROW(line.at(0.0), std::logic_error);
  }
  // From the land, along the side edges.
  const auto beach = makeBuiltinSeafloor("plane:facing=90");
  IncidentWave offLand;
  offLand.directionFrom = 270.0;
  EXPECT_EQ(LaunchLine(*beach, 0.0, offLand, Aground, { EdgeRule::Contours }).length(), 0.0);
  EXPECT_EQ(LaunchLine(*beach, 0.0, offLand, Aground, { EdgeRule::None }).length(), 0.0);
}

TEST(LaunchLine, refusesABadWave)
{
  const auto beach = makeBuiltinSeafloor("plane");
  IncidentWave wave;
  EXPECT_THROW(LaunchLine(*beach, 0.0, wave, 0.0, { EdgeRule::None }), std::invalid_argument);
  EXPECT_THROW(
    LaunchLine(*beach, 0.0, wave, std::numeric_limits<double>::quiet_NaN(), { EdgeRule::None }), std::invalid_argument);
  wave.period = 0.0;
  EXPECT_THROW(LaunchLine(*beach, 0.0, wave, Aground, { EdgeRule::None }), std::invalid_argument);
}
