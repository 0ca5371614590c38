#pragma once

#include "sim/IncidentWave.h"
#include "sim/Seafloor.h"

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

/** Where and how one ray starts. */
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
 * the wave first meets the scene.
 */
class LaunchLine
{
public:
  /** A stretch of one edge over water without a gap, in the order of the perimeter. */
  struct Segment
  {
    double firstLambda = 0.0; ///< m
    double lastLambda = 0.0;  ///< m
    int piece = 0;            ///< segments of one piece follow each other without a gap
  };

  /**
   * @param aground depth below which the edge counts as land, m, > 0
   * @param shoreNormal nautical degrees the seaward normal of the contours points to, for EdgeRule::Contours;
   *   none: of the plane fitted to the wet depths, and no refraction where that plane's slope is below 1e-4
   * @throws std::invalid_argument on a bad wave or depth
   */
  LaunchLine(const Seafloor& seafloor, double waterLevel, const IncidentWave& wave, double aground, EdgeRule rule,
    std::optional<double> shoreNormal = {});

  /** Total length along the incident crest, m; 0 where the wave comes in nowhere over water. */
  double length() const { return this->Length; }

  /** Start of the ray with this parameter, 0 <= lambda <= length(). */
  LaunchPoint at(double lambda) const;

  const std::vector<Segment>& segments() const { return this->Segments; }

private:
  struct Node;
  struct Edge;
  std::vector<Segment> Segments;
  double Length = 0.0;
};

}
