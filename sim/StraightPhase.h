#pragma once

#include "sim/IncidentWave.h"
#include "sim/Seafloor.h"
#include "sim/sections/PeacheySection.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <vector>

namespace swellray
{

/**
 * Phase of a wave as Peachey 1986, section 3.2, has it: integrated along straight lines in the direction of the wave in
 * deep water, from the line across it that first touches the scene,
 *
 *   S(x) = int_0^x k(h(u)) du,
 *
 * on a grid, bilinear between its nodes. Crests bend as depths ask, but rays do not: the gradient of S across the lines is
 * no part of any wave, and its size is not k. It is kept for comparison; the traced phase takes its place elsewhere.
 */
class StraightPhase
{
public:
  /**
   * @param waterLevel m, positive up
   * @param spacing of the nodes, m, > 0
   * @throws std::invalid_argument bad wave, spacing not above 0, or more than a hundred million nodes
   */
  StraightPhase(const Seafloor& seafloor, const IncidentWave& wave, double waterLevel, double spacing);

  /** S, rad; at the nearest place of the scene beyond it. */
  double at(const glm::dvec2& place) const;

private:
  glm::dvec2 Along{ 1.0, 0.0 };
  glm::dvec2 Origin{ 0.0 };
  double Spacing = 1.0;
  std::size_t Columns = 0; // along the wave
  std::size_t Rows = 0;
  std::vector<double> Phase;
};

/** One wave of a sea of Peachey 1986. */
struct PeacheyWave
{
  IncidentWave wave;
  double phase = 0.0; ///< rad, at the origin at time 0
};

/**
 * The sea of Peachey 1986, eq. 4: several long-crested waves of straight phase, each with its profile by steepness and
 * depth (PeacheySection), simply added; one height a place. All are lowered alike where the sum of their amplitudes
 * comes near the depth, so that it never goes beyond it.
 */
class PeacheySea
{
public:
  /** The seafloor must outlive this. @throws std::invalid_argument as StraightPhase, or without waves */
  PeacheySea(const Seafloor& seafloor, const std::vector<PeacheyWave>& waves, double waterLevel, double spacing,
    const PeacheySection::Parameters& parameters = {});

  /** Height above still water, m; 0 on land. */
  double height(const glm::dvec2& place, double time) const;

private:
  struct Component
  {
    double omega = 0.0;
    double height = 0.0;
    double phase = 0.0;
    double gravity = 9.81;
    StraightPhase grid;
  };

  const Seafloor& Bed;
  double WaterLevel;
  PeacheySection Section;
  std::vector<Component> Components;
  double Amplitudes = 0.0; // sum
};

}
