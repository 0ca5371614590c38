#pragma once

#include "sim/Execution.h"
#include "sim/RaySheets.h"

#include <array>
#include <complex>
#include <vector>

namespace swellray
{

/** The wave that both branches of a fold caustic make at a place next to it. */
struct FoldShare
{
  std::complex<double> wave; ///< m; its phase is that of the two sheets, the caustics before this one counted
  double weight = 0.0;       ///< 0 to 1: share that it has
  double hides = 0.0; ///< 0 to 1: share that it takes from the two sheets: none far into the dark, where there are none
  int number = 0;     ///< caustics passed by the branch behind it
  int reflections = 0; ///< by obstacles
  double middle = 0.0; ///< S between the branches, rad
  double half = 0.0;   ///< half the phase between them, rad; 0 on the dark side
  glm::dvec2 wavenumber{ 0.0 };
};

/**
 * Strips along fold caustics, on which the sheets of rays are too coarse and, on the dark side, no rays are: there the
 * two branches are one wave,
 *
 *   u = sqrt(pi) exp(i (M - pi/4)) (G Ai(-z) - i D Ai'(-z)),
 *
 * whose M, z, G and D are smooth across the caustic (Ludwig 1966). At a place x + n N, x on the caustic and N its normal to
 * the side of the rays, they are, with k the wavenumber on the caustic,
 *
 *   z = (2 K^2 kappa)^(1/3) n + z2 n^2,  M = S + (k.N) n + M2 n^2,  G = G0 + G1 n,  D = D0
 *
 * where G0 is what foldPeak() says and the rest is what makes them those of the two sheets where z = 1.5 (without two
 * sheets there: 0). Along the caustic, between the places that neighbouring rays touch, they are linear, x and S cubic by
 * their own slopes. A strip reaches from z = -5, where 2e-4 of the height is left, to z = 1.5, from z = 0.75 on giving way
 * to the sheets. There is none where a cusp is nearer than the spread of the fold's own field along the caustic.
 */
class FoldStrips
{
public:
  /** @param sheets with caustics; must outlive this */
  explicit FoldStrips(const RaySheets& sheets, const Execution& execution = {});

  std::size_t size() const { return this->Strips.size(); }

  /** Smallest rectangle with a strip. */
  Rectangle box(std::size_t strip) const { return this->Strips[strip].box; }

  /** The wave at a place; false where the strip does not cover it. */
  bool wave(std::size_t strip, const glm::dvec2& place, FoldShare& share) const;

private:
  /** What holds at a place that a ray touches. */
  struct Node
  {
    glm::dvec2 position{ 0.0 };
    glm::dvec2 along{ 0.0 };  // unit vector of the ray
    glm::dvec2 normal{ 0.0 }; // to the side of the rays
    glm::dvec2 wavenumber{ 0.0 };
    double phase = 0.0;
    double z1 = 0.0;
    double z2 = 0.0;
    double m1 = 0.0;
    double m2 = 0.0;
    double g0 = 0.0;
    double g1 = 0.0;
    double d0 = 0.0;
    std::int32_t number = 0;
    std::int32_t reflections = 0;
    bool fold = false;
  };

  struct Strip
  {
    std::size_t a = 0;
    std::size_t b = 0;
    double length = 0.0; // signed by the way of the rays
    double low = 0.0;    // n, m
    double high = 0.0;
    Rectangle box;
  };

  Node nodeOf(const RayCaustic& caustic) const;
  void fit(std::vector<Node>& nodes, const Execution& execution) const;
  void join(const std::vector<std::size_t>& sorted);
  glm::dvec2 place(const Strip& strip, double u, double n) const;

  const RaySheets& Sheets;
  std::vector<Node> Nodes; // a caustic of a ray each
  std::vector<Strip> Strips;
};

}
