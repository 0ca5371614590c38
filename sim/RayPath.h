#pragma once

#include "sim/Current.h"
#include "sim/MapScale.h"
#include "sim/Obstacles.h"
#include "sim/RayField.h"
#include "sim/Seafloor.h"

#include <optional>
#include <vector>

namespace swellray
{

/**
 * What a ray travels through. On a map of the curved Earth positions are those on the map, and so are the lengths of
 * the seafloor and the current as functions of them; all other quantities (depths, speeds, wavenumbers, ways, widths)
 * are true ones.
 */
struct RayMedium
{
  const Seafloor* seafloor = nullptr;
  double waterLevel = 0.0;              ///< m, positive up
  double gravity = 9.81;                ///< m/s2
  double angularFrequency = 0.0;        ///< rad/s
  double agroundDepth = 0.1;            ///< a ray ends where it gets shallower than this, m, > 0
  const Current* current = nullptr;     ///< none: still water
  const Obstacles* obstacles = nullptr; ///< none: nothing stands in the water
  const MapScale* map = nullptr;        ///< none: the plane is true to scale

  double depth(const glm::dvec2& p) const { return waterLevel - seafloor->elevation(p); }

  /** Map length over true length at a point. */
  double scale(const glm::dvec2& p) const { return map ? map->scale(p) : 1.0; }
};

/**
 * Initial state of a ray. The derivatives by the launch parameter lambda describe the ray tube. Of a map it is the state
 * on the map: wavenumbers are the true ones over the map's scale.
 */
struct RayStart
{
  glm::dvec2 position{ 0.0 };      ///< m
  glm::dvec2 wavenumber{ 0.0 };    ///< rad/m
  glm::dvec2 dPosition{ 0.0 };     ///< d position / d lambda, -
  glm::dvec2 dWavenumber{ 0.0 };   ///< d wavenumber / d lambda, rad/m2
  double phase = 0.0;              ///< rad
  double travelTime = 0.0;         ///< s
  double length = 0.0;             ///< m travelled
  int caustics = 0;                ///< passed before
  std::optional<std::size_t> wall; ///< on which it starts, having been reflected
  double wallSide = 1.0;           ///< of that wall, as in WallHit
};

/** Quantity in which fronts are equally spaced. */
enum class FrontMeasure
{
  Phase,  ///< rad: fronts are crests
  Length, ///< m travelled
  Time,   ///< s of travel
};

/**
 * One ray on its way: advances from front to front and says what ended it.
 *
 * A path is used by one thread at a time. No step allocates memory, unless it touches a caustic.
 */
class RayPath
{
public:
  virtual ~RayPath() = default;

  /**
   * Go on to where the measure reaches the target, or to the ray's end, and describe that place. Targets
   * must not decrease. The spacing width, front and state of `point` are left alone.
   * @return true when the target was reached, false when the ray ended before
   */
  virtual bool advance(FrontMeasure measure, double target, RayPoint& point) = 0;

  /** Caustics touched up to the point last described, with no curvature: that takes neighbours. */
  virtual std::vector<RayCaustic> caustics() { return {}; }

  bool ended() const { return this->Ended; }
  /** What ended the ray; only meaningful once ended(). */
  EndReason endReason() const { return this->Reason; }
  /** The wall that stopped the ray; set where it was stopped by an obstacle. */
  const std::optional<WallHit>& wall() const { return this->Wall; }
  /**
   * How the wave goes on from the wall that stopped the ray, with k - 2 n (n.k) for k (on a current, where that would be
   * a wave of another period, with the component along n that keeps it), the same phase, and the tube of the mirrored
   * rays, its sign kept. None where nothing is reflected, at a corner, and where the ray runs along the wall.
   */
  const std::optional<RayStart>& reflection() const { return this->Reflected; }
  /** Metres travelled at the point last described. */
  double length() const { return this->ReadLength; }
  /** Largest ||k|/k(h) - 1| seen; on a current |(sigma + k.U)/omega - 1|. */
  double dispersionError() const { return this->DispersionError; }
  /** Steps made so far. */
  std::size_t steps() const { return this->Steps; }
  /** Evaluations of the ray equations so far. */
  std::size_t evaluations() const { return this->Evaluations; }

protected:
  bool Ended = false;
  EndReason Reason = EndReason::StepCap;
  double ReadLength = 0.0;
  double DispersionError = 0.0;
  std::size_t Steps = 0;
  std::size_t Evaluations = 0;
  std::optional<WallHit> Wall;
  std::optional<RayStart> Reflected;
};

}
