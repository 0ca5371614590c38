#include "sim/MildSlope.h"

#include "sim/Angles.h"
#include "sim/MildSlopeField.h"
#include "sim/MildSlopeIncident.h"
#include "sim/MildSlopeLosses.h"
#include "sim/MildSlopeMesh.h"
#include "sim/NestedDissection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace swellray
{

namespace
{

// Nodes in the shortest wavelength unless set, and the fewest that are taken.
constexpr double StandardNodes = 10.0;
constexpr double FewestNodes = 4.0;

// Fewer are not proposed where a scene is too large.
constexpr double FewestGoodNodes = 6.0;

// Share of the depth in which the incident wave breaks from which on there is coast.
constexpr double CoastShare = 0.5;

// A side of the scene is looked at for its depths at so many places.
constexpr std::size_t Soundings = 500;

// Iteration of losses and dispersion: change at which it ends, and steps at most.
constexpr double SettledChange = 2e-3;
constexpr std::size_t MostSolutions = 30;

// Multiplications a second of one thread of a machine of 2020: for estimates.
constexpr double WorkRate = 5e8;

// Bytes a node besides the factorisation: media, surface, load, residual.
constexpr double BytesOfANode = 160.0;

constexpr double SmallResidual = 1e-10;
constexpr int MostRefinements = 3;

void require(bool holds, const char* rule, double value)
{
  if (!holds)
  {
    std::ostringstream message;
    message << rule << ", not " << value;
    throw std::invalid_argument(message.str());
  }
}

struct DepthRange
{
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
};

// Least and largest depth of the water that is deeper than this; the least is this where some is shallower.
DepthRange soundDepths(const Seafloor& seafloor, double waterLevel, double minDepth)
{
  const Rectangle bounds = seafloor.bounds();
  DepthRange range;
  for (std::size_t j = 0; j <= Soundings; ++j)
  {
    for (std::size_t i = 0; i <= Soundings; ++i)
    {
      const glm::dvec2 place = bounds.low +
        bounds.size() * (glm::dvec2(static_cast<double>(i), static_cast<double>(j)) / static_cast<double>(Soundings));
      if (!seafloor.isHole(place))
      {
        const double depth = waterLevel - seafloor.elevation(place);
        range.least = std::min(range.least, depth);
        range.most = std::max(range.most, depth);
      }
    }
  }
  range.least = std::max(range.least, minDepth);
  return range;
}

void lay(
  MildSlopePlan& plan, const Rectangle& bounds, double spacing, const IncidentWave& wave, bool feedback, bool sideWalls)
{
  plan.layout = layOut(bounds, spacing, plan.longestWave, wave, sideWalls);
  const auto& padding = plan.layout.padding;
  const std::size_t columns = plan.layout.sceneColumns + padding[0] + padding[1];
  const std::size_t rows = plan.layout.sceneRows + padding[2] + padding[3];
  plan.columns = columns + 1;
  plan.rows = rows + 1;
  plan.spacing = bounds.size() /
    glm::dvec2(static_cast<double>(plan.layout.sceneColumns), static_cast<double>(plan.layout.sceneRows));
  plan.nodesPerWave = plan.shortestWave / std::max(plan.spacing.x, plan.spacing.y);
  const DissectionCost cost = NestedDissection::cost(columns, rows);
  plan.bytes = cost.bytes + BytesOfANode * plan.nodes();
  plan.seconds = cost.operations / WorkRate;
  plan.solutions = feedback ? MostSolutions : 1;
}

[[noreturn]] void refuse(
  const MildSlopePlan& plan, const Rectangle& bounds, const IncidentWave& wave, const MildSlopeOptions& options)
{
  MildSlopePlan smaller = plan;
  double spacing = std::max(plan.spacing.x, plan.spacing.y);
  while (smaller.bytes > options.memory && spacing < bounds.size().x + bounds.size().y)
  {
    spacing *= std::max(1.02, std::sqrt(0.9 * smaller.bytes / options.memory));
    lay(smaller, bounds, spacing, wave, false, options.sideWalls);
  }
  MildSlopePlan cropped = plan;
  Rectangle crop = bounds;
  while (cropped.bytes > options.memory && crop.size().x > 4.0 * plan.spacing.x)
  {
    crop.high = crop.low + crop.size() * std::min(0.98, std::sqrt(options.memory / cropped.bytes));
    lay(cropped, crop, std::max(plan.spacing.x, plan.spacing.y), wave, false, options.sideWalls);
  }
  std::ostringstream message;
  message.precision(3);
  message << "a mild-slope field of " << plan.columns << " x " << plan.rows << " nodes " << plan.spacing.x
          << " m apart needs " << 1e-9 * plan.bytes << " GB of memory, more than the " << 1e-9 * options.memory
          << " GB that it may take: ";
  if (smaller.nodesPerWave >= FewestGoodNodes)
  {
    message << "a spacing of the nodes of " << smaller.spacing.x << " m would fit (" << smaller.nodesPerWave
            << " in the shortest wavelength), or ";
  }
  message << "a crop to " << crop.size().x << " m x " << crop.size().y << " m";
  throw std::invalid_argument(message.str());
}

// load less A u, and the largest of its size over the largest of the load's.
double residualOf(const MildSlopeMesh& mesh, const std::vector<std::complex<double>>& load,
  const std::vector<std::complex<double>>& eta, std::vector<std::complex<double>>& residual)
{
  residual = load;
  const std::size_t along = mesh.columns() + 1;
  NestedDissection::Element values;
  for (std::size_t j = 0; j < mesh.rows(); ++j)
  {
    for (std::size_t i = 0; i < mesh.columns(); ++i)
    {
      mesh.element(i, j, values);
      for (std::size_t a = 0; a < 4; ++a)
      {
        std::complex<double> sum = 0.0;
        for (std::size_t b = 0; b < 4; ++b)
        {
          sum += values[4 * a + b] * eta[(j + b / 2) * along + i + b % 2];
        }
        residual[(j + a / 2) * along + i + a % 2] -= sum;
      }
    }
  }
  double largest = 0.0;
  double error = 0.0;
  for (std::size_t n = 0; n < load.size(); ++n)
  {
    if (mesh.unknown()[n])
    {
      largest = std::max(largest, std::norm(load[n]));
      error = std::max(error, std::norm(residual[n]));
    }
  }
  return largest > 0.0 ? std::sqrt(error / largest) : 0.0;
}

}

void MildSlopeOptions::validate() const
{
  require(!this->spacing || (*this->spacing > 0.0 && std::isfinite(*this->spacing)),
    "the spacing of the nodes must be above 0 m", this->spacing.value_or(0.0));
  require(!this->minDepth || (*this->minDepth > 0.0 && std::isfinite(*this->minDepth)),
    "the smallest depth must be above 0 m", this->minDepth.value_or(0.0));
  require(this->coastReflection >= 0.0 && this->coastReflection <= 1.0,
    "the reflection of the coast must be within 0 to 1", this->coastReflection);
  require(this->memory >= 0.0, "the memory must not be below 0", this->memory);
  this->height.validate();
}

MildSlopePlan planMildSlope(
  const Seafloor& seafloor, double waterLevel, const IncidentWave& wave, const MildSlopeOptions& options)
{
  wave.validate();
  options.validate();
  const Rectangle bounds = seafloor.bounds();
  MildSlopePlan plan;
  plan.minDepth = options.minDepth.value_or(CoastShare * wave.height / breakerIndex(options.height, wave));
  const DepthRange depths = soundDepths(seafloor, waterLevel, plan.minDepth);
  if (!(depths.most >= plan.minDepth))
  {
    std::ostringstream message;
    message << "no water in the scene is deeper than " << plan.minDepth << " m, where the coast begins";
    throw std::runtime_error(message.str());
  }
  const double omega = wave.angularFrequency();
  plan.shortestWave = wavelengthOf(solveWavenumber(omega, depths.least, wave.gravity));
  plan.longestWave = wavelengthOf(solveWavenumber(omega, depths.most, wave.gravity));
  const bool feedback = MildSlopeFeedback(wave, options).needed();
  const double spacing = options.spacing.value_or(plan.shortestWave / StandardNodes);
  lay(plan, bounds, spacing, wave, feedback, options.sideWalls);
  if (plan.nodesPerWave < FewestNodes)
  {
    std::ostringstream message;
    message << "nodes " << spacing << " m apart are " << plan.nodesPerWave << " in the shortest wavelength, "
            << plan.shortestWave << " m in " << depths.least << " m of water; at least 4 are needed, 10 are good";
    throw std::invalid_argument(message.str());
  }
  if (options.memory > 0.0 && plan.bytes > options.memory)
  {
    refuse(plan, bounds, wave, options);
  }
  return plan;
}

MildSlopeField solveMildSlope(const Seafloor& seafloor, double waterLevel, const IncidentWave& wave,
  const MildSlopeOptions& options, const Execution& execution)
{
  const MildSlopePlan plan = planMildSlope(seafloor, waterLevel, wave, options);
  MildSlopeField field;
  field.Kept = std::make_unique<MildSlopeField::Data>(MildSlopeField::Data{
    MildSlopeMesh(seafloor, waterLevel, wave, options, plan, execution), MildSlopeFeedback(wave, options), {}, {} });
  MildSlopeMesh& mesh = field.Kept->mesh;
  MildSlopeFeedback& feedback = field.Kept->feedback;
  std::vector<std::complex<double>>& eta = field.Kept->eta;
  const MildSlopeIncident incident(seafloor, waterLevel, wave, options, plan.minDepth, mesh);
  NestedDissection solver(mesh.columns(), mesh.rows(), mesh.unknown());
  const auto element = [&mesh](std::size_t i, std::size_t j, NestedDissection::Element& values)
  { mesh.element(i, j, values); };

  feedback.begin(mesh);
  std::vector<std::complex<double>> residual;
  for (bool settled = false; !settled && field.Solutions < MostSolutions;)
  {
    Execution part = execution;
    if (execution.progress)
    {
      // How many solutions it takes is not known: each takes a fifth of what is left.
      const double done = feedback.needed() ? 1.0 - std::pow(0.8, static_cast<double>(field.Solutions)) : 0.0;
      const double share = feedback.needed() ? 0.2 * (1.0 - done) : 1.0;
      part.progress = [&execution, done, share](double s) { return execution.progress(done + share * s); };
    }
    if (!solver.factor(element, part))
    {
      field.Cancelled = true;
      return field;
    }
    const std::vector<std::complex<double>> load = incident.load();
    eta = load;
    solver.solve(eta);
    field.Residual = residualOf(mesh, load, eta, residual);
    for (int i = 0; i < MostRefinements && field.Residual > SmallResidual; ++i)
    {
      solver.solve(residual);
      std::transform(eta.begin(), eta.end(), residual.begin(), eta.begin(), std::plus<>());
      field.Residual = residualOf(mesh, load, eta, residual);
    }
    ++field.Solutions;
    settled = true;
    if (feedback.needed())
    {
      field.Change = feedback.update(mesh, eta);
      settled = field.Change < SettledChange;
    }
  }
  field.Kept->prepare();
  return field;
}

bool MildSlopeField::converged() const
{
  return this->Change < SettledChange;
}

}
