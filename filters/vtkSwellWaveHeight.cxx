#include "vtkSwellWaveHeight.h"

#include "AlgorithmExecution.h"
#include "CausticField.h"
#include "FieldData.h"
#include "RayArrays.h"
#include "sim/FoldsBeside.h"
#include "sim/WaveHeight.h"

#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <exception>
#include <numeric>
#include <vector>

vtkStandardNewMacro(vtkSwellWaveHeight);

namespace
{

// Rays between two looks at the abort flag.
constexpr std::size_t RaysAtOnce = 4096;

/** Rays in an order in which parents come before those inserted beside them, in groups without kinship. */
struct Generations
{
  std::vector<std::size_t> order;
  std::vector<std::size_t> begins{ 0 };

  Generations(const int* parents, std::size_t rays)
  {
    std::vector<std::size_t> generation(rays, 0);
    std::size_t last = 0;
    for (std::size_t ray = 0; ray < rays; ++ray)
    {
      if (hasParent(parents, ray))
      {
        generation[ray] = generation[static_cast<std::size_t>(parents[ray])] + 1;
        last = std::max(last, generation[ray]);
      }
    }
    this->order.resize(rays);
    std::iota(this->order.begin(), this->order.end(), std::size_t(0));
    std::stable_sort(this->order.begin(), this->order.end(),
      [&](std::size_t a, std::size_t b) { return generation[a] < generation[b]; });
    for (std::size_t i = 1; i <= rays; ++i)
    {
      if (i == rays || generation[this->order[i]] != generation[this->order[i - 1]])
      {
        this->begins.push_back(i);
      }
    }
  }

  // Parents are older; what a file says else is no kinship.
  static bool hasParent(const int* parents, std::size_t ray)
  {
    return parents && parents[ray] >= 0 && static_cast<std::size_t>(parents[ray]) < ray;
  }
};

swellray::RayLossArrays raySlice(swellray::RayLossArrays losses, std::int64_t begin, std::int64_t end)
{
  losses.count = static_cast<std::size_t>(end - begin);
  losses.phase += begin;
  losses.share += begin;
  losses.friction += begin;
  losses.breakingDistance += begin;
  losses.breaking += begin;
  losses.breakerType += begin;
  losses.state += begin;
  return losses;
}

}

int vtkSwellWaveHeight::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    const swellray::IncidentWave wave = swellray::tracedWave(input);
    wave.validate();
    swellray::HeightOptions options;
    options.amplitude = static_cast<swellray::AmplitudeRule>(this->AmplitudeRule);
    options.breaking = static_cast<swellray::BreakingRule>(this->BreakingRule);
    if (this->Gamma != 0.0)
    {
      options.gamma = this->Gamma;
    }
    options.friction = this->Friction;
    options.viscosity = this->Viscosity;
    options.caustics = static_cast<swellray::CausticRule>(this->CausticRule);
    options.maxRefraction = this->MaxRefraction;
    options.validate();

    const std::vector<std::int64_t> offsets = swellray::rayOffsets(input);
    const std::size_t rays = offsets.size() - 1;
    const vtkIdType points = input->GetNumberOfPoints();
    vtkPointData* in = input->GetPointData();
    const vtkSmartPointer<vtkDoubleArray> positions = swellray::positionsOf(input);
    const auto travelTime = swellray::requireDoubles(in, "TravelTime", points);
    const auto depth = swellray::requireDoubles(in, "Depth", points);
    const auto wavenumber = swellray::requireDoubles(in, "Wavenumber", points);
    const auto groupSpeed = swellray::requireDoubles(in, "GroupSpeed", points);
    const auto shoaling = swellray::requireDoubles(in, "ShoalingCoefficient", points);
    const auto krSpacing = swellray::requireDoubles(in, "KrSpacing", points);
    const auto krTube = swellray::requireDoubles(in, "KrTube", points);
    const auto state = swellray::requireBytes(in, "RayState", points);
    const auto phase = swellray::requireDoubles(in, "Phase", points);
    swellray::RayCaustics caustics = swellray::causticsOf(input);
    const auto parent = rays > 0
      ? swellray::requireIntegers(input->GetCellData(), "ParentRay", static_cast<vtkIdType>(rays))
      : vtkSmartPointer<vtkIntArray>::New();
    const auto reflections = input->GetCellData()->GetArray("ReflectionCoefficient")
      ? swellray::requireDoubles(input->GetCellData(), "ReflectionCoefficient", static_cast<vtkIdType>(rays))
      : vtkSmartPointer<vtkDoubleArray>();
    swellray::RayProfile all;
    all.position = positions->GetPointer(0);
    const auto scale = swellray::mapScaleOf(input);
    all.scale = scale ? scale->GetPointer(0) : nullptr;
    all.travelTime = travelTime->GetPointer(0);
    all.depth = depth->GetPointer(0);
    all.wavenumber = wavenumber->GetPointer(0);
    all.groupSpeed = groupSpeed->GetPointer(0);
    all.shoaling = shoaling->GetPointer(0);
    all.krSpacing = krSpacing->GetPointer(0);
    all.krTube = krTube->GetPointer(0);
    all.state = state->GetPointer(0);
    all.phase = phase->GetPointer(0);

    output->ShallowCopy(input);
    vtkPointData* out = output->GetPointData();
    double* refraction = swellray::addArray<vtkDoubleArray>(out, "RefractionCoefficient", points);
    double* height = swellray::addArray<vtkDoubleArray>(out, "WaveHeight", points);
    double* energyFlux = swellray::addArray<vtkDoubleArray>(out, "EnergyFlux", points);
    double* orbitalVelocity = swellray::addArray<vtkDoubleArray>(out, "OrbitalVelocity", points);
    unsigned char* breaking = swellray::addArray<vtkUnsignedCharArray>(out, "Breaking", points);
    unsigned char* breakerType = swellray::addArray<vtkUnsignedCharArray>(out, "BreakerType", points);
    double* distance = swellray::addArray<vtkDoubleArray>(out, "BreakingDistance", points);
    vtkNew<vtkDoubleArray> frictions;
    frictions->SetName("FrictionCoefficient");
    frictions->SetNumberOfTuples(points);
    double* friction = frictions->GetPointer(0);
    if (options.rubs())
    {
      out->AddArray(frictions);
    }
    double* brokenShare = swellray::ofRandomWaves(options.breaking)
      ? swellray::addArray<vtkDoubleArray>(out, "BrokenShare", points)
      : nullptr;
    swellray::setFieldString(output, "BreakingRule", swellray::breakingRuleName(options.breaking));
    swellray::setFieldString(output, "CausticRule", swellray::causticRuleName(options.caustics));
    swellray::setFieldValue(output, "BreakerIndex", swellray::breakerIndex(options, wave));

    swellray::TouchingRays touching;
    touching.rays = rays;
    touching.offsets = offsets.data();
    touching.caustics = caustics.caustics.data();
    touching.causticOffsets = caustics.offsets.data();
    touching.phase = all.phase;
    touching.wavenumber = all.wavenumber;
    touching.krTube = all.krTube;
    touching.state = all.state;
    std::vector<double> beside;
    if (!caustics.caustics.empty() && options.caustics == swellray::CausticRule::Uniform)
    {
      const auto count = static_cast<vtkIdType>(rays);
      const auto parameter = swellray::requireDoubles(input->GetCellData(), "LaunchParameter", count);
      const auto segment = swellray::requireIntegers(input->GetCellData(), "LaunchSegment", count);
      const auto lee = swellray::requireBytes(input->GetCellData(), "LeeRay", count);
      touching.launchParameter = parameter->GetPointer(0);
      touching.launchSegment = segment->GetPointer(0);
      touching.lee = lee->GetPointer(0);
      caustics.caustics = swellray::loneCausticRates(touching);
      touching.caustics = caustics.caustics.data();
      beside = swellray::foldsBeside(touching, swellray::makeExecution(this, 0.0, 0.1));
    }

    std::vector<double> share(static_cast<std::size_t>(points));
    swellray::RayLossArrays losses;
    losses.phase = phase->GetPointer(0);
    losses.share = share.data();
    losses.friction = friction;
    losses.breakingDistance = distance;
    losses.breaking = breaking;
    losses.breakerType = breakerType;
    losses.state = all.state;
    const int* const parents = rays > 0 ? parent->GetPointer(0) : nullptr;
    const Generations generations(parents, rays);

    const swellray::Execution execution = swellray::makeExecution(this, 0.1, 1.0);
    std::size_t generation = 1;
    for (std::size_t first = 0, count = 0; first < rays; first += count)
    {
      generation += first == generations.begins[generation] ? 1 : 0;
      count = std::min(RaysAtOnce, generations.begins[generation] - first);
      execution.forRange(count,
        [&](std::size_t begin, std::size_t end)
        {
          swellray::RayHeights heights;
          for (std::size_t i = first + begin; i < first + end; ++i)
          {
            const std::size_t ray = generations.order[i];
            const std::int64_t at = offsets[ray];
            swellray::RayProfile profile = all;
            profile.count = static_cast<std::size_t>(offsets[ray + 1] - at);
            profile.position += 3 * at;
            profile.scale = profile.scale ? profile.scale + at : nullptr;
            profile.travelTime += at;
            profile.depth += at;
            profile.wavenumber += at;
            profile.groupSpeed += at;
            profile.shoaling += at;
            profile.krSpacing += at;
            profile.krTube += at;
            profile.state += at;
            profile.reflection = reflections ? reflections->GetPointer(0)[ray] : 1.0;
            profile.phase += at;
            profile.caustics = caustics.caustics.data() + caustics.offsets[ray];
            profile.causticCount = caustics.offsets[ray + 1] - caustics.offsets[ray];
            profile.foldBeside = beside.empty() ? nullptr : beside.data() + at;
            if (profile.count > 0 && Generations::hasParent(parents, ray))
            {
              const auto other = static_cast<std::size_t>(parents[ray]);
              profile.before =
                swellray::lossesAt(raySlice(losses, offsets[other], offsets[other + 1]), losses.phase[at]);
            }
            swellray::computeHeights(profile, wave, options, heights);
            std::copy(heights.refraction.begin(), heights.refraction.end(), refraction + at);
            std::copy(heights.height.begin(), heights.height.end(), height + at);
            std::copy(heights.energyFlux.begin(), heights.energyFlux.end(), energyFlux + at);
            std::copy(heights.orbitalVelocity.begin(), heights.orbitalVelocity.end(), orbitalVelocity + at);
            std::copy(heights.breaking.begin(), heights.breaking.end(), breaking + at);
            std::copy(heights.breakerType.begin(), heights.breakerType.end(), breakerType + at);
            std::copy(heights.breakingDistance.begin(), heights.breakingDistance.end(), distance + at);
            std::copy(heights.friction.begin(), heights.friction.end(), friction + at);
            std::copy(heights.share.begin(), heights.share.end(), share.begin() + at);
            if (brokenShare)
            {
              std::copy(heights.brokenShare.begin(), heights.brokenShare.end(), brokenShare + at);
            }
          }
        });
      if (!execution.report(static_cast<double>(first + count) / static_cast<double>(rays)))
      {
        output->Initialize();
        return 1;
      }
    }
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkSwellWaveHeight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AmplitudeRule: " << (this->AmplitudeRule == TUBE ? "tube" : "spacing") << "\n";
  os << indent
     << "BreakingRule: " << swellray::breakingRuleName(static_cast<swellray::BreakingRule>(this->BreakingRule)) << "\n";
  os << indent << "CausticRule: " << swellray::causticRuleName(static_cast<swellray::CausticRule>(this->CausticRule))
     << "\n";
  os << indent << "Gamma: " << this->Gamma << "\n";
  os << indent << "Friction: " << this->Friction << "\n";
  os << indent << "Viscosity: " << this->Viscosity << "\n";
  os << indent << "MaxRefraction: " << this->MaxRefraction << "\n";
}
