#pragma once

#include "Case.h"

#include "RayComparison.h"

namespace swellray::validation
{

/** A ray and its exact places. */
struct Track
{
  std::function<RayStart(const RayMedium&)> start;
  std::vector<reference::Place> places;
};

/** Rays over a seafloor. */
struct RayScene
{
  const Seafloor* seafloor = nullptr;
  const Current* current = nullptr;
  double period = 10.0;       ///< s
  double agroundDepth = 0.01; ///< m
  FrontMeasure by = FrontMeasure::Length;
  std::vector<Track> tracks;
  std::function<double(const reference::Place&)> depth; ///< exact, m
  bool map = false;                                     ///< draw x and y to the same scale
};

/** What the errors at the finest tolerance of the integrator may be. */
struct RayLimits
{
  double position = 3e-9;  ///< m a km of path, m on the first
  double relative = 2e-10; ///< rad; relative
  double width = 1e-9;     ///< relative, of a tenth where the tube is narrower
  std::string positionReason = "some thousand steps, each right to 1e-12 of a wavelength near 100 m, add up to less";
  std::string widthReason = "the tube is held to fewer digits than its ray";
};

/** Tolerance of a step at which a ray is as good as double precision lets it be. */
constexpr double FineTolerance = 1e-12;

RayMedium mediumOf(const RayScene& scene, const Setting& setting);

/** Quantity of a place in which the rays of the scene are followed. */
double targetOf(const RayScene& scene, const reference::Place& place);

/** A seafloor whose derivatives are wrong by the factors of a setting. */
class WrongSeafloor final : public Seafloor
{
public:
  WrongSeafloor(const Seafloor& seafloor, const Setting& setting)
    : Right(seafloor)
    , Slope(setting.bedSlope)
    , Curvature(setting.bedCurvature)
  {
  }

  Rectangle bounds() const override { return this->Right.bounds(); }
  void evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const override
  {
    this->Right.evaluate(p, region, bed);
    bed.gradient *= this->Slope;
    bed.xx *= this->Curvature;
    bed.xy *= this->Curvature;
    bed.yy *= this->Curvature;
  }
  double featureLength() const override { return this->Right.featureLength(); }
  double resolution() const override { return this->Right.resolution(); }
  double cellSize() const override { return this->Right.cellSize(); }
  unsigned kinkCount() const override { return this->Right.kinkCount(); }
  double kinkLevel(unsigned i, const glm::dvec2& p, glm::dvec2& gradient) const override
  {
    return this->Right.kinkLevel(i, p, gradient);
  }

private:
  const Seafloor& Right;
  double Slope;
  double Curvature;
};

/**
 * Trace the rays and compare positions, headings, phases, times, tubes and heights with the exact places: at the finest
 * tolerance, at the default one, and by the order in which the errors fall with the tolerance.
 */
Outcome compareRays(const RayScene& scene, const RayLimits& limits, const Setting& setting);

/** Errors of the rays at one tolerance; a ray that ends early makes the position infinitely wrong. */
reference::RayErrors rayErrors(
  const RayScene& scene, const Setting& setting, double tolerance, std::size_t* evaluations = nullptr);

/** The checks of an error each for position, heading, phase and time. */
void addPathChecks(
  const reference::RayErrors& errors, const RayLimits& limits, const std::string& suffix, std::vector<Check>& checks);

}
