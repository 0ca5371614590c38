#pragma once

#include <glm/vec2.hpp>

#include <optional>

namespace swellray
{

/**
 * A current has stopped a wave where its energy moves along the wavenumber at less than this share of its group
 * speed: k.(Cg k/|k| + U) < share k Cg.
 */
constexpr double BlockedShare = 0.01;

/**
 * Wave of a given absolute frequency on a current:
 *
 *   sigma(|k|, h) + k.U = omega,  k = n along + across left(along)                (1)
 *
 * with left(along) the unit vector to the left of `along`. Of the roots n > 0 the one that carries energy along
 * `along` (at most one), by Newton's method kept in a bracket, to 1e-13 relative.
 *
 * @param omega rad/s, > 0
 * @param depth h, m, > 0, finite
 * @param along unit vector
 * @param across rad/m
 * @param current U, m/s
 * @return n, rad/m; nothing where there is none, or where the current has stopped the wave
 */
std::optional<double> solveOnCurrent(
  double omega, double depth, double gravity, const glm::dvec2& along, double across, const glm::dvec2& current);

}
