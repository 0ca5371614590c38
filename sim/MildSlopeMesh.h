#pragma once

#include "sim/Execution.h"
#include "sim/IncidentWave.h"
#include "sim/MildSlope.h"
#include "sim/NestedDissection.h"
#include "sim/Seafloor.h"

#include <array>
#include <complex>
#include <cstdint>
#include <vector>

namespace swellray
{

/** The four sides of a scene. */
enum class MeshSide : std::size_t
{
  West,
  East,
  South,
  North,
};

/**
 * Elements of four nodes over a scene, with absorbing layers around it.
 *
 * Everything of an element depends on its place in the scene, of a layer on the element of the scene that is nearest: the bed goes on
 * outward as it is on the edge. Coordinates of the layers are stretched by s = 1 + i a xi^2, a complex number, xi from 0 to 1
 * through the layer (Berenger 1994; Chew and Weedon 1994), after one element without.
 *
 * Element matrix, with h the sides, kappa = k h, the mass matrices m(b) = h ((1-b)/2, b/2; b/2, (1-b)/2) and the
 * stiffness k1 = (1, -1; -1, 1)/h of two nodes:
 *
 *   f p ((k1 x m(bs)) + (m(bs) x k1)) - f (p k^2 + i omega W) m(bm) x m(bm),   p = C Cg
 *
 * b = 1/6 would be 4th order (Guddati and Yue 2004). Here bm = 1/X - 2/kappa^2, X = 1 - cos kappa, leaves no error of the
 * wavenumber along the axes, and bs none at 45 degrees (in the manner of Babuska et al. 1995), and f = tan(kappa/2)/(kappa/2) gives the
 * element the impedance of the wave, so that a wave over varying depth keeps its energy flux.
 */
class MildSlopeMesh
{
public:
  using Complex = std::complex<double>;

  /** What an element is. */
  enum class Kind : std::uint8_t
  {
    Water,
    Coast,
    Wall,
  };

  /** What holds in an element of the scene. */
  struct Medium
  {
    double depth = 0.0;      ///< mean, not below the smallest depth, m
    double flux = 0.0;       ///< C Cg, m2/s2
    double stiffness = 0.0;  ///< k^2 C Cg of linear waves, 1/s2
    double factor = 1.0;     ///< (k/k linear)^2
    double loss = 0.0;       ///< W, 1/s
    double admittance = 1.0; ///< of what is no water, (1 - R)/(1 + R)
    Kind kind = Kind::Coast;

    double wavenumber() const;       ///< rad/m
    double linearWavenumber() const; ///< rad/m
  };

  MildSlopeMesh(const Seafloor& seafloor, double waterLevel, const IncidentWave& wave, const MildSlopeOptions& options,
    const MildSlopePlan& plan, const Execution& execution);

  std::size_t columns() const { return this->Columns; } ///< elements, with the layers
  std::size_t rows() const { return this->Rows; }
  std::size_t sceneColumns() const { return this->SceneColumns; } ///< elements
  std::size_t sceneRows() const { return this->SceneRows; }
  const glm::dvec2& spacing() const { return this->Spacing; }
  const glm::dvec2& origin() const { return this->Origin; } ///< first node of the scene
  std::size_t padding(MeshSide side) const { return this->Padding[static_cast<std::size_t>(side)]; }
  bool isOpen(MeshSide side) const { return padding(side) > 0; }

  /** Index of a node of the scene among all nodes. */
  std::size_t node(std::size_t i, std::size_t j) const
  {
    return (j + this->padding(MeshSide::South)) * (this->Columns + 1) + i + this->padding(MeshSide::West);
  }
  glm::dvec2 place(std::size_t i, std::size_t j) const
  {
    return this->Origin + this->Spacing * glm::dvec2(static_cast<double>(i), static_cast<double>(j));
  }

  Medium& medium(std::size_t i, std::size_t j) { return this->Media[j * this->SceneColumns + i]; }
  const Medium& medium(std::size_t i, std::size_t j) const { return this->Media[j * this->SceneColumns + i]; }
  const std::vector<Medium>& media() const { return this->Media; }

  /** Nodes at which eta is sought: 1, else 0. */
  const std::vector<std::uint8_t>& unknown() const { return this->Unknown; }

  /** Matrix of element (i, j) of all. */
  void element(std::size_t i, std::size_t j, NestedDissection::Element& values) const;

  /** Element of the scene whose medium that of all has, along one axis. */
  std::size_t sceneColumn(std::size_t i) const;
  std::size_t sceneRow(std::size_t j) const;

private:
  void setMedia(const Seafloor& seafloor, double waterLevel, const MildSlopeOptions& options, double minDepth,
    const Execution& execution);
  void setUnknowns();
  Kind kindAt(std::ptrdiff_t i, std::ptrdiff_t j) const;
  double coastShare(std::size_t i, std::size_t j) const;

  std::size_t SceneColumns = 0;
  std::size_t SceneRows = 0;
  std::size_t Columns = 0;
  std::size_t Rows = 0;
  std::array<std::size_t, 4> Padding{};
  glm::dvec2 Spacing{ 1.0 };
  glm::dvec2 Origin{ 0.0 };
  double Omega = 1.0;
  double Gravity = StandardGravity;
  std::vector<Medium> Media;
  std::vector<Complex> StretchX; // one a column of elements
  std::vector<Complex> StretchY;
  std::vector<std::uint8_t> Unknown;
};

/** Layout of a mesh with this spacing; `wallSides`: no layers on the sides along which the wave runs. */
MeshLayout layOut(
  const Rectangle& bounds, double spacing, double longestWave, const IncidentWave& wave, bool wallSides);

}
