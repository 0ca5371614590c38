#pragma once

#include "sim/MildSlope.h"
#include "sim/MildSlopeLosses.h"
#include "sim/MildSlopeMesh.h"

#include <complex>
#include <cstdint>
#include <vector>

namespace swellray
{

/** What a solved field is read from: the surface on the nodes, interpolated by polynomials of order 5, lower beside coasts. */
struct MildSlopeField::Data
{
  /** eta and its gradient at a place. */
  struct Surface
  {
    std::complex<double> eta;
    std::complex<double> dx;
    std::complex<double> dy;
    std::size_t element = 0; ///< of the scene
  };

  MildSlopeMesh mesh;
  MildSlopeFeedback feedback;
  std::vector<std::complex<double>> eta; ///< one a node of the mesh
  std::vector<std::uint32_t> dry;        ///< elements of the scene without water below and left of a node

  void prepare();
  /** False on land and outside of the scene. */
  bool surfaceAt(const glm::dvec2& place, Surface& surface) const;
  /** What holds at a place, between the middles of the elements in water around it. */
  MildSlopeMesh::Medium mediumAt(const glm::dvec2& place, std::size_t element) const;
  void wavesAt(const glm::dvec2& place, std::size_t index, MildSlopeWaves& waves) const;

private:
  bool allWater(std::size_t i, std::size_t j, std::size_t columns, std::size_t rows) const;
};

}
