#pragma once

#include "sim/Crests.h"
#include "sim/Obstacles.h"
#include "sim/RayCaustic.h"
#include "sim/Seafloor.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace swellray
{

/** Rays with their heights as plain arrays, as they lie in a ray file. */
struct SheetRays
{
  RayLines lines;                            ///< rays, their points and phases
  const std::int32_t* parent = nullptr;      ///< a ray, -1 for a launched one
  const std::uint8_t* lee = nullptr;         ///< a ray, 1: a model of diffraction
  const std::int32_t* reflections = nullptr; ///< a ray, by obstacles; null: none anywhere
  const std::uint8_t* endReason = nullptr;   ///< a ray, EndReason; needed with obstacles, and by GaussianBeams at edges
  const Obstacles* obstacles = nullptr;      ///< null: none
  const double* direction = nullptr;         ///< 3 a point: unit vector of the wavenumber
  const double* wavenumber = nullptr;        ///< a point, rad/m
  const double* height = nullptr;            ///< a point, m; infinite allowed
  const std::int32_t* caustics = nullptr;    ///< a point
  const std::uint8_t* breaking = nullptr;    ///< a point
  const std::uint8_t* state = nullptr;       ///< a point, RayState

  /**
   * Refraction coefficient with which the height was made, and signed width of the ray tube (beta), a point. With both of
   * them WaveSheet::branch is free of all that keeps heights finite at caustics; null: it is the height.
   */
  const double* refraction = nullptr;
  const double* tubeWidth = nullptr;

  const RayCaustic* touched =
    nullptr; ///< places at which the rays touch caustics; RayCaustic::ray is one of these rays
  std::size_t touchedCount = 0;
};

/** The wave that one sheet of rays brings to a place. */
struct WaveSheet
{
  double height = 0.0; ///< m
  double branch = 0.0; ///< geometric height, m: of this branch of a caustic alone, growing without limit towards it
  glm::dvec2 wavenumber{ 0.0 }; ///< rad/m
  double phase = 0.0;           ///< S, rad
  int caustics = 0;             ///< passed (KMAH index)
  int reflections = 0;          ///< by obstacles
  bool broken = false;
  bool lee = false; ///< by rays that model diffraction
};

/**
 * The sheet that neighbouring rays span: a triangulated surface over the plane, folded where rays cross, so that a
 * place can be covered several times.
 *
 * Neighbours in launch parameter (within a launch segment) are joined point by point in the order of their phase. An
 * inserted ray begins with the triangle between its neighbours; a ray that ends breaks the sheet between those on
 * either side of it. Reflected rays begin where the wall reflects them, as launched ones do at the edge of the scene. No
 * triangle spans only points of the shore, nor one over a gap wider than the limits, nor one with a wall between two of
 * its rays.
 *
 * Inside a triangle with weights w_i of its corners x_i, height is linear (where a corner is infinite 1/H^2 is, as
 * the width of a ray tube), and the phase is
 *
 *   S(x) = sum w_i (S_i + k_i.(x - x_i)/2),
 *
 * exact for quadratic S since k (on a map of the Earth k over its scale) is its gradient. The orientation of a triangle
 * is the sign of the ray tube's width (the other one after an odd number of reflections): it decides between corners that
 * disagree about the caustics passed.
 */
class RaySheets
{
public:
  using Triangle = std::array<std::int64_t, 3>; ///< indices of points

  /**
   * The arrays of `rays` must outlive this.
   * @param maxSpacing distance of neighbours beyond which rays were inserted, m; 0: gaps of any width are spanned.
   *   Otherwise the sheet breaks where neighbours are more than 8 times that apart (rays between them would carry next
   *   to nothing), and 2 times where one is a lee ray or aground (there more were inserted unless that was switched off)
   * @throws std::runtime_error where a position, phase, wavenumber or direction is not finite
   */
  RaySheets(const SheetRays& rays, double maxSpacing);

  const SheetRays& rays() const { return this->Rays; }

  /** Ordered along the rays; the same for the same rays. */
  const std::vector<Triangle>& triangles() const { return this->Triangles; }

  /** Smallest rectangle with all points of the rays. */
  const Rectangle& bounds() const { return this->Bounds; }

  /**
   * Where a place is looked at: by a ten-millionth of the size of the bounds nearer to their middle, so that what lies
   * on the edge of the scene is inside.
   */
  glm::dvec2 inwards(const glm::dvec2& place) const;

  /** Smallest rectangle with a triangle. */
  Rectangle box(const Triangle& triangle) const;

  /** The wave at a place; false where the triangle does not cover it. Of triangles with a common edge one does. */
  bool wave(const Triangle& triangle, const glm::dvec2& place, WaveSheet& wave) const;

private:
  friend class SheetWeaver;

  glm::dvec2 position(std::int64_t point) const;
  std::int64_t besideWall(std::int64_t point) const;

  SheetRays Rays;
  std::vector<std::uint8_t> LeePoint;    // a point
  std::vector<std::int32_t> Reflections; // a point; empty: none anywhere
  std::vector<std::int8_t> Beside;       // from a point on a wall to the one beside it on its ray; empty: no walls
  std::vector<Triangle> Triangles;
  Rectangle Bounds;
};

}
