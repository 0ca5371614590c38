#pragma once

#include "sim/Current.h"
#include "sim/IncidentWave.h"
#include "sim/MapScale.h"
#include "sim/Obstacles.h"
#include "sim/Seafloor.h"
#include "sim/WaveSource.h"

#include <optional>
#include <vector>

namespace swellray
{

/** How the incident wave is brought from offshore to the edges of the scene. */
enum class EdgeRule
{
  Contours, ///< refracted over straight parallel contours with one normal for the scene
  Edge,     ///< the same with contours parallel to each edge
  None,     ///< the offshore direction as given
};

/**
 * Unit normal of the contours of a scene, towards the shore.
 * @param given nautical degrees that its seaward normal points to; none: of the plane fitted to the wet depths
 * @return none where that plane's slope is below 1e-4: the direction of waves at the edge is taken as given then
 */
std::optional<glm::dvec2> contourNormal(const Seafloor& seafloor, double waterLevel, std::optional<double> given);

/** A point at which one ray starts. */
struct LaunchPlace
{
  glm::dvec2 position{ 0.0 }; ///< m
  std::optional<double>
    heading{}; ///< of the wave there, going to, rad; none: that of the incident wave, brought there by the rule
};

/** What the incident wave meets on its way to the rays' start, and where that is. What is pointed to must outlive the launch line. */
struct LaunchOptions
{
  EdgeRule rule = EdgeRule::Contours;
  std::optional<double> shoreNormal{}; ///< nautical degrees that the seaward normal of the contours points to, for
                                       ///< EdgeRule::Contours; none: of the plane fitted to the wet depths
  const Current* current = nullptr;
  const Obstacles* obstacles = nullptr;
  const MapScale* map = nullptr;
  const WaveSource* source = nullptr; ///< a point that the wave comes from; none: a plane wave
  std::vector<std::vector<glm::dvec2>>
    lines{};                         ///< where rays start in place of the scene's edges: poly-lines within it, m
  std::vector<LaunchPlace> places{}; ///< or points
};

/** Where and how one ray starts: on a map of the Earth the state on the map (RayStart). */
struct LaunchPoint
{
  glm::dvec2 position{ 0.0 };    ///< m
  glm::dvec2 wavenumber{ 0.0 };  ///< rad/m
  glm::dvec2 dPosition{ 0.0 };   ///< derivative of the position along the line by lambda, -
  glm::dvec2 dWavenumber{ 0.0 }; ///< derivative of the wavenumber by lambda, rad/m2
  double phase = 0.0;            ///< S at launch, rad
  int segment = 0;
};

/**
 * The edges through which the incident wave comes in over water, as one line with the parameter
 *
 *   lambda = integral of |t.n_edge| (cos theta0 / cos theta) dl
 *
 * in metres along the incident crest (t: ray direction at the edge, n_edge: edge normal, theta0 and theta:
 * angle to the contours' normal offshore and at the edge). Phase is integrated along the edges, 0 where
 * the wave first meets the scene. The edges are walked clockwise, so that lambda grows to the left of the rays.
 *
 * With EdgeRule::Contours the wavenumber along the contours is kept, K = k0 (t0.tau), and the rest follows from
 * k(h): exact on any straight beach, at its side edges too. Nothing comes in where k < |K| or where the wave
 * runs along the contours.
 *
 * With a current the rest follows from sigma(|k|, h) + k.U = omega, and t and theta are those of the ray, dx/dt = Cg
 * k/|k| + U: lambda is then the wave action that comes in, per metre of crest offshore, where there is no current.
 * Nothing comes in where the current stops the wave.
 *
 * Nothing comes in on the land inside of obstacles.
 *
 * On a map of the Earth directions are true ones (azimuths), dl and lambda true metres: the wave has the direction
 * offshore, refracted as the rule says, at every place of the edge.
 *
 * A wave that comes from a point (WaveSource) has at every place of the edge the direction of the ray that comes there over
 * water of one depth, refracted from there on as a plane wave of that direction would be. Its height and crest are those at the place where
 * it first meets the scene, with the tube's width b0 there: elsewhere, b wide, it brings b0/b of the energy,
 *
 *   lambda = integral of |t.n_edge| (cos theta0/cos theta) (b0/b) dl = b0 times the angle at the source.
 *
 * Lines within the scene (LaunchOptions) take the place of its edges: each is turned so that the wave crosses it, as a whole, from its
 * left to its right, and has the phase 0 where the wave first meets it. Points have a ray each, with no neighbours, lambda
 * counts them (the i-th from 0 to i + 1/2) and their phase is 0; the tube at a point is that of a metre of the incident crest.
 *
 * The seafloor and what the options point to must outlive the line.
 */
class LaunchLine
{
public:
  /**
   * @param aground depth below which the edge counts as land, m, > 0
   * @throws std::invalid_argument on a bad wave or depth, and on a source that the waves have come from too far around the Earth, or
   *   on the edge; std::runtime_error on a line that leaves the scene, and on a point from which no wave can start
   */
  LaunchLine(const Seafloor& seafloor, double waterLevel, const IncidentWave& wave, double aground,
    const LaunchOptions& options = {});

  /** Total length along the incident crest, m; 0 where the wave comes in nowhere over water. */
  double length() const { return this->Length; }

  /** Spacing of the only rays that there are; none where there may be any number of them. */
  std::optional<double> raySpacing() const;

  /** Start of the ray with this parameter, 0 <= lambda <= length(). */
  LaunchPoint at(double lambda) const;

  /**
   * Wavenumber vector, rad/m, that the incident wave has at a place on the edge of the scene whose inward unit normal is
   * this, also where it does not come in: in water no shallower than the aground depth. 0 where the rule has no wave.
   */
  glm::dvec2 wavenumberAt(const glm::dvec2& place, const glm::dvec2& inward) const;

  /** The wave where it first meets the scene: of a plane wave, as it is given. */
  double directionFrom() const { return this->DirectionFrom; } ///< offshore, nautical degrees
  /** Way from the source to there, m; none of a plane wave. */
  const std::optional<double>& sourceDistance() const { return this->SourceDistance; }

  /** Unit normal of the contours, towards the shore; nothing where the direction is taken as given. */
  const std::optional<glm::dvec2>& contourNormal() const { return this->ContourNormal; }

private:
  /** One side of the scene, walked clockwise: the inside lies to the right. */
  struct Side
  {
    glm::dvec2 corner{ 0.0 };
    glm::dvec2 along{ 0.0 };
    glm::dvec2 inward{ 0.0 };
    double length = 0.0;
    int chain = 0;                   // the line that it is of
    std::optional<double> heading{}; // of the wave, in place of the rule
  };

  /** A short stretch of a side through which the wave comes in over water everywhere, or nowhere. */
  struct Stretch
  {
    int side = 0;
    int segment = 0;
    double from = 0.0; ///< m along the side
    double to = 0.0;
    double lambda = 0.0; ///< at from, m
    double phase = 0.0;  ///< at from, rad
    double rise = 0.0;   ///< of the phase over the stretch, rad
    double width = 0.0;  ///< of lambda over the stretch, m
  };

  /** The wave at a place on a side; of a map as it is on the map. */
  struct EdgeWave
  {
    glm::dvec2 wavenumber{ 0.0 };
    glm::dvec2 dWavenumber{ 0.0 }; ///< along the side, rad/m2
    double density = 0.0;          ///< d lambda / dl; 0 where the wave does not come in
    bool enters = false;
  };

  /** The offshore wave at a place of a side. */
  struct Offshore
  {
    glm::dvec2 direction{ 0.0 };
    double turn = 0.0;   ///< of the direction along the side, anticlockwise, rad/m
    double spread = 1.0; ///< crest there over crest at the reference
  };

  Offshore offshoreAt(const Side& side, double l) const;
  std::vector<std::vector<glm::dvec2>> chains() const;
  void findReferences();
  void standPlaces();
  void takeReference(const SourceSample& sample);
  EdgeWave edgeWave(const Side& side, double l) const;
  LaunchPoint pointOf(const Side& side, double l) const;
  void bringToMap(const Side& side, double l, EdgeWave& wave) const;
  std::optional<double> solveAlong(
    double depth, const glm::dvec2& along, double across, const glm::dvec2& velocity) const;
  glm::dvec2 integrate(const Side& side, double from, double to) const;
  void walk(const Side& side, int index, bool& open, int& segment);
  void append(int index, int segment, double from, double to);

  const Seafloor* Floor;
  LaunchOptions Options;
  double WaterLevel;
  IncidentWave Wave;
  double Aground;
  std::optional<glm::dvec2> ContourNormal;
  std::vector<Side> Sides;
  std::vector<Stretch> Stretches;
  double Length = 0.0;
  double Perimeter = 0.0;
  double ReferenceWidth = 1.0; // of the source's tube, m
  double DirectionFrom = 0.0;
  std::optional<double> SourceDistance;
};

}
