#pragma once

#include "sim/GaussianBeams.h"

#include <cstdint>
#include <vector>

namespace swellray
{

/** Finds the foci of rays, and makes beams of the rays around them (GaussianBeams). */
class BeamBuilder
{
public:
  /** Beams end where this is what is left of them: exp(-9.2) = 1e-4. */
  static constexpr double LargestExponent = 9.2;

  explicit BeamBuilder(GaussianBeams& beams);

  void build(const Execution& execution);

private:
  using Point = GaussianBeams::Point;

  /** What a point of a ray brings along. */
  struct Place
  {
    Point point;
    double tube = 0.0;   // signed width
    double time = 0.0;   // integral of dS/k^2, m2
    double height = 0.0; // of a tube of width 1, m
    int caustics = 0;
  };

  /** A ray among its neighbours. */
  struct Ray
  {
    std::size_t index = 0;
    double first = 0.0; // S, extensions included
    double last = 0.0;
    bool launched = false;
    std::int64_t begin = 0; // points on the water
    std::int64_t end = 0;
    bool before = false; // goes on straight before its first point
    bool beyond = false; // and beyond its last
  };

  /** Way in lambda to a neighbour, and how far the family ends there, 0 to 1. */
  struct Side
  {
    double gap = 0.0;
    double end = 0.0;
  };

  /** Half, out to where beams end, on the map. */
  static double widthOf(const Point& point);

  void findFoci();
  void sortRays();
  std::vector<Place> placesOf(const Ray& ray) const;
  std::vector<Point> pointsOf(std::size_t order) const;
  std::complex<double> spreadAt(const Place& place, const std::vector<double>& timesAtFoci) const;
  Side side(std::size_t order, double phase, int direction) const;
  double presence(const Ray& ray, double phase) const;
  double ending(const Ray& ray, double phase) const;
  bool matters(const Point& point) const;

  GaussianBeams& Beams;
  const SheetRays& Rays;
  std::vector<Ray> Sorted; // by launch segment and parameter
  double Extension = 0.0;  // true m
};

}
