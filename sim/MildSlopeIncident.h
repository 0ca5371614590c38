#pragma once

#include "sim/MildSlopeMesh.h"

#include <complex>
#include <vector>

namespace swellray
{

/**
 * The incident wave on the outline of a scene: as LaunchLine brings it there, its phase integrated along the sides from the corner
 * that it meets first, its height H0 sqrt(Cg0 cos theta0/(Cg cos theta)) with the losses that BreakingMarch gives it on its way along the
 * sides; none where it would have come over land or through a wall of the scene. From the outline it goes on outward, one element wide, as the plane wave that it is there.
 */
class MildSlopeIncident
{
public:
  MildSlopeIncident(const Seafloor& seafloor, double waterLevel, const IncidentWave& wave,
    const MildSlopeOptions& options, double minDepth, const MildSlopeMesh& mesh);

  /**
   * Right side of the equations: inside of the scene and on its outline the unknown is the whole wave, in the layers what it
   * differs by from the incident one. One entry a node.
   */
  std::vector<std::complex<double>> load() const;

private:
  struct EdgeNode
  {
    std::complex<double> eta = 0.0;
    glm::dvec2 wavenumber{ 0.0 };
  };

  /** A node of the outline; every side's nodes follow each other. */
  struct Stop
  {
    std::size_t i = 0;
    std::size_t j = 0;
    MeshSide side = MeshSide::West;
  };

  void walk(const std::vector<Stop>& stops, const Seafloor& seafloor, double waterLevel, const IncidentWave& wave,
    const MildSlopeOptions& options, double minDepth, const LaunchLine& line);
  bool isShadowed(const Stop& stop, const glm::dvec2& direction) const;
  EdgeNode& at(std::size_t i, std::size_t j) { return this->Nodes[j * (this->Mesh->sceneColumns() + 1) + i]; }
  const EdgeNode& at(std::size_t i, std::size_t j) const
  {
    return this->Nodes[j * (this->Mesh->sceneColumns() + 1) + i];
  }

  const MildSlopeMesh* Mesh;
  std::vector<EdgeNode> Nodes;
};

}
