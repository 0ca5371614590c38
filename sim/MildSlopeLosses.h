#pragma once

#include "sim/MildSlopeMesh.h"

#include <complex>
#include <cstdint>
#include <vector>

namespace swellray
{

/** What a wave field does to itself: losses and dispersion that depend on its height. */
class MildSlopeFeedback
{
public:
  MildSlopeFeedback(const IncidentWave& wave, const MildSlopeOptions& options);

  /** True where a solution changes the equations that it came from. */
  bool needed() const { return this->Losses || this->Dispersion; }

  /** Set the losses that do not depend on heights: those of a laminar boundary layer. */
  void begin(MildSlopeMesh& mesh) const;

  /**
   * Set the losses and the dispersion of the elements by the heights of a solution.
   *
   * Losses less than those of the solution let more energy through, which loses more: so the losses are not those of its energy E
   * but of E exp(d), d what they make of it down the wave,
   *
   *   Cg t.grad d = W(solution) - W(E exp d)
   *
   * upwind on the elements, along the direction t of the wave, swept in four orders (Zhao 2005). The dispersion goes
   * half the way to what follows from the heights (under-relaxation).
   *
   * W is that of bottom friction (frictionRate(), laminarFrictionRate()) and of breaking, with Cg the group speed and Hm the largest height of the rule:
   *
   *   gamma, weggel, miche   (Cg/h) (1 - (Hm/H)^2), H > Hm: Dally's equation with a coefficient of 1, by which H is above Hm by
   *                          1.25 times the slope of the bed where it breaks
   *   dally                  K (Cg/h) (1 - (0.4 h/H)^2), K = 0.15, from where H > gamma h on, down the wave, until H <= 0.4 h
   *   battjes-janssen        randomWaveLossRate(H/Hm)
   *   baldock                baldockLossRate(H/Hb, H/h)
   *
   * @param eta one a node of the mesh
   * @return root mean square change of the heights since the call before, over that of the heights; 1 the first time
   */
  double update(MildSlopeMesh& mesh, const std::vector<std::complex<double>>& eta);

  /** One an element of the scene: 1 where the wave breaks; of random waves where more than 5 % do. */
  const std::vector<std::uint8_t>& breaking() const { return this->Broken; }

  /** The largest height that the rule leaves a wave, m; infinity where it has none; of baldock that above which waves break. */
  double limit(const MildSlopeMesh::Medium& medium, double slope) const;

  /** A height, no higher than the limit of a rule whose waves are saturated. */
  double cap(const MildSlopeMesh::Medium& medium, double height) const;

private:
  double laminarLoss(const MildSlopeMesh::Medium& medium) const;
  void findBroken(const MildSlopeMesh& mesh);
  double slopeAt(const MildSlopeMesh& mesh, std::size_t i, std::size_t j) const;
  double lossAt(const MildSlopeMesh::Medium& medium, double groupSpeed, double height, double limit, bool broken) const;
  void setLosses(MildSlopeMesh& mesh, const std::vector<std::complex<double>>& eta);

  IncidentWave Wave;
  HeightOptions Options;
  double Gamma;
  bool Losses;
  bool Dispersion;
  bool Started = false;
  std::vector<double> Heights; // one an element of the scene, m
  std::vector<std::uint8_t> Broken;
};

}
