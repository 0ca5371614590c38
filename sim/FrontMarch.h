#pragma once

#include "sim/LaunchLine.h"
#include "sim/RayPath.h"
#include "sim/ShorelineWalk.h"
#include "sim/WaveTracer.h"

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

namespace swellray
{

/**
 * The state of a dynamic wave tracing: all rays, the order in which they stand along the front, and the fronts
 * recorded so far. One object traces one scene.
 */
class FrontMarch
{
public:
  FrontMarch(const RayMedium& medium, const IncidentWave& wave, const TraceOptions& options, const LaunchLine& line,
    const Execution& execution);

  /** Trace until no ray is left on the water, and hand over the rays. */
  RayField run();

private:
  struct Ray
  {
    RayInfo info;
    std::unique_ptr<RayPath> path;
    std::vector<RayCaustic> caustics; // once it has no path any more
    ShorelineWalk walk;
    RayState state = RayState::Alive;
    bool waiting = true;             // the front has not come to its launch point yet
    RayPoint place;                  // on the current front
    std::array<RayPoint, 2> between; // launch, and grounding or end, since the last front
    int betweenCount = 0;
    double measure = 0.0;         // phase or length reached
    bool launching = false;       // its place on this front is its launch point
    std::int32_t reflected = -1;  // the ray in which it goes on from a wall
    glm::dvec2 wallNormal{ 0.0 }; // of the wall that reflected it
  };

  /** A ray in its place along the front. */
  struct Standing
  {
    std::uint32_t ray = 0;
    bool linked = false;  // the next one is its neighbour
    bool blocked = false; // but on this front an obstacle stands between the two
  };

  enum class Insertion
  {
    Retrace,
    Interpolate,
    Lee,
  };

  struct InsertionJob
  {
    std::size_t after = 0; // place along the front
    Insertion kind = Insertion::Retrace;
    Ray ray;
    bool keep = false;
    bool severed = false; // what would stand between has left the scene: the two are no neighbours any more
  };

  /** Rays of one launch segment that one obstacle reflects: while tracing, they have a launch segment of their own. */
  struct Mirror
  {
    std::int32_t from = 0; // launch segment
    std::size_t obstacle = 0;
  };

  enum class Mirrored
  {
    Done,
    NotYet,    // the wall lies beyond the front
    Elsewhere, // another wall, or none
  };

  struct Record
  {
    std::uint32_t ray = 0;
    RayPoint point;
  };

  std::unique_ptr<RayPath> makePath(const RayStart& start) const;
  RayStart launch(double lambda, int& segment) const;
  void launchAll();
  double frontValue() const;
  double measureOf(const RayStart& start) const;
  void advance(Ray& ray, double target) const;
  void walkOn(Ray& ray, double target) const;
  void settleEnded();
  void settleShore();
  void insertRays();
  double distance(const RayPoint& a, const RayPoint& b) const;
  bool wantsInsertion(std::size_t at, Insertion& kind) const;
  void makeInsertion(InsertionJob& job, double target) const;
  Mirrored mirror(Ray& ray, RayStart& start, double target) const;
  std::optional<double> wavenumberAt(const glm::dvec2& position, const glm::dvec2& direction) const;
  std::optional<RayStart> startBetween(const Ray& a, const Ray& b) const;
  void reflectEnded();
  bool goesOn(const Ray& ray) const;
  std::int32_t mirrorSegment(std::int32_t from, std::size_t obstacle);
  Ray reflectedRay(std::uint32_t index);
  void stand(std::uint32_t index);
  bool areNeighbours(const Ray& a, const Ray& b) const;
  void remember(std::uint32_t index);
  void splitMirrors();
  void findBlocked();
  double heightOf(const Ray& ray) const;
  void measureSpacing();
  double spacingWidth(std::size_t at) const;
  const Ray* neighbour(std::size_t at, int step, const Ray& self) const;
  void markFlat();
  void record(std::uint32_t index, bool withPlace);
  void retire(std::uint32_t index);
  void recordFront();
  double shoreStep() const;
  bool anyOnWater() const;
  void finishRemaining(EndReason reason);
  RayField collect();

  const Ray& standing(std::size_t at) const { return this->Rays[this->Order[at].ray]; }
  Ray& standing(std::size_t at) { return this->Rays[this->Order[at].ray]; }

  RayMedium Medium;
  IncidentWave Wave;
  TraceOptions Options;
  const LaunchLine& Line;
  const Execution& Run;
  FrontMeasure Measure = FrontMeasure::Phase;
  double FrontStep = 1.0;
  double Spacing = 1.0;
  double MaxSpacing = 1.5;
  double StepsPerWave = 0.0; // 0: fronts of equal length
  double SnellStep = 1.0;
  std::uint32_t Front = 0;
  std::vector<Ray> Rays;
  std::vector<Standing> Order;
  std::vector<std::vector<Record>> Records; // a front each
  std::vector<Mirror> Mirrors;              // launch segment FirstMirror + i
  std::int32_t FirstMirror = 0;
  std::set<std::tuple<std::int32_t, double, std::uint32_t>>
    Family; // launch segment, parameter, ray: where walls reflect
  std::size_t Points = 0;
  std::size_t Steps = 0;
  std::size_t Evaluations = 0;
  bool RayCapReached = false;
  bool StepCapReached = false;
  bool Cancelled = false;
};

}
