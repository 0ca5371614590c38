#include "SurfaceScene.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "ObstacleSource.h"
#include "RayArrays.h"
#include "RaySheetInput.h"
#include "SeafloorField.h"
#include "sim/Dispersion.h"
#include "sim/WaveHeight.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <mutex>

namespace swellray
{

namespace
{

template <typename Array, typename Value>
vtkSmartPointer<vtkDataArray> makeArray(const char* name, const std::vector<Value>& values)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

}

std::shared_ptr<const SurfaceScene> SurfaceScene::of(vtkPolyData* rays, vtkImageData* image, vtkDataArray* elevation,
  SeafloorField& seafloor, const Settings& settings, vtkAlgorithm* algorithm)
{
  // A time of modification is given to one object once in a process.
  struct Known
  {
    vtkMTimeType rays;
    vtkMTimeType image;
    vtkMTimeType elevation;
    Settings settings;
    std::weak_ptr<const SurfaceScene> scene;
  };
  static std::mutex mutex;
  static std::vector<Known> scenes;
  const std::lock_guard<std::mutex> lock(mutex);
  scenes.erase(std::remove_if(scenes.begin(), scenes.end(), [](const Known& known) { return known.scene.expired(); }),
    scenes.end());
  const vtkMTimeType elevationTime = elevation ? elevation->GetMTime() : 0;
  for (const Known& known : scenes)
  {
    if (known.rays == rays->GetMTime() && known.image == image->GetMTime() && known.elevation == elevationTime &&
      known.settings == settings)
    {
      if (auto scene = known.scene.lock())
      {
        return scene;
      }
    }
  }
  auto scene = std::make_shared<const SurfaceScene>(rays, seafloor.get(image, elevation), settings, algorithm);
  scenes.push_back({ rays->GetMTime(), image->GetMTime(), elevationTime, settings, scene });
  return scene;
}

SurfaceScene::SurfaceScene(
  vtkPolyData* rays, std::shared_ptr<const Seafloor> seafloor, const Settings& settings, vtkAlgorithm* algorithm)
  : Bed(std::move(seafloor))
  , Walls(obstaclesOf(rays))
{
  const IncidentWave wave = tracedWave(rays);
  this->Options.period = wave.period;
  this->Options.wavelength = wavelengthOf(wave.wavenumber());
  this->Options.waterLevel = fieldValue(rays, "WaterLevel").value_or(0.0);
  this->Options.breakerIndex = fieldValue(rays, "BreakerIndex").value_or(StandardGamma);
  this->Options.seed = static_cast<std::uint64_t>(settings.seed);
  this->Options.gravity = wave.gravity;
  this->Options.groups = settings.groups;
  settings.groups.validate();
  {
    const SheetArrays arrays(rays);
    const vtkIdType points = rays->GetNumberOfPoints();
    const auto rayDirection = requireDoubles(rays->GetPointData(), "RayDirection", points, 3);
    const auto distance = requireDoubles(rays->GetPointData(), "BreakingDistance", points);
    SurfaceRays input;
    input.sheet = arrays.rays();
    input.rayDirection = rayDirection->GetPointer(0);
    input.breakingDistance = distance->GetPointer(0);
    input.maxSpacing = fieldValue(rays, "MaxSpacing").value_or(0.0);
    this->Sheet = std::make_unique<SurfaceSheet>(
      input, *this->Bed, this->Options.waterLevel, settings.pointsPerWave, makeExecution(algorithm, 0.0, 0.3));
  }
  const SurfaceSheet& sheet = *this->Sheet;
  this->Surface = std::make_unique<WaveSurface>(sheet, *this->Bed, this->Options, makeExecution(algorithm, 0.3, 0.5));

  if (settings.straight)
  {
    // As fine as the points along the rays are at least.
    const double spacing = this->Options.wavelength / settings.pointsPerWave;
    this->Surface->setPhase(StraightPhase(*this->Bed, wave, this->Options.waterLevel, spacing));
  }

  const auto triangles = static_cast<vtkIdType>(sheet.Triangles.size());
  vtkNew<vtkTypeInt64Array> offsets;
  offsets->SetNumberOfValues(triangles + 1);
  vtkNew<vtkTypeInt64Array> connectivity;
  connectivity->SetNumberOfValues(3 * triangles);
  for (vtkIdType i = 0; i <= triangles; ++i)
  {
    offsets->SetValue(i, 3 * i);
  }
  for (vtkIdType i = 0; i < 3 * triangles; ++i)
  {
    connectivity->SetValue(i, sheet.Triangles[static_cast<std::size_t>(i / 3)][static_cast<std::size_t>(i % 3)]);
  }
  this->Triangles = vtkSmartPointer<vtkCellArray>::New();
  this->Triangles->SetData(offsets, connectivity);

  std::vector<double> phase(sheet.pointCount());
  std::vector<double> breakingPhase(sheet.pointCount());
  std::vector<double> foamShare(sheet.pointCount());
  std::vector<double> plungePhase(sheet.pointCount());
  std::vector<double> launchParameter(sheet.pointCount(), 0.0);
  for (std::size_t i = 0; i < breakingPhase.size(); ++i)
  {
    phase[i] = this->Surface->phase(i);
    const FoamOrigin origin = this->Surface->foamOrigin(i);
    breakingPhase[i] = origin.begin;
    foamShare[i] = origin.share;
    plungePhase[i] = origin.plunge;
  }
  for (std::size_t ray = 0; ray < sheet.rayCount(); ++ray)
  {
    std::fill(launchParameter.begin() + sheet.Offsets[ray], launchParameter.begin() + sheet.Offsets[ray + 1],
      sheet.LaunchParameter[ray]);
  }
  for (std::size_t i = 0; i < sheet.BeachBase.size(); ++i)
  {
    launchParameter[sheet.rayPointCount() + i] = launchParameter[static_cast<std::size_t>(sheet.BeachBase[i])];
  }
  this->Arrays = { makeArray<vtkDoubleArray>("RayPhase", phase),
    makeArray<vtkDoubleArray>("BreakingPhase", breakingPhase), makeArray<vtkDoubleArray>("FoamShare", foamShare),
    makeArray<vtkDoubleArray>("PlungePhase", plungePhase),
    makeArray<vtkDoubleArray>("LaunchParameter", launchParameter),
    makeArray<vtkDoubleArray>("WaveHeight", sheet.Height), makeArray<vtkUnsignedCharArray>("RayState", sheet.State) };
  if (settings.groups.any())
  {
    std::vector<double> groupTime(sheet.pointCount());
    std::vector<double> brokenShare(sheet.pointCount());
    for (std::size_t i = 0; i < sheet.pointCount(); ++i)
    {
      const std::size_t of =
        i < sheet.rayPointCount() ? i : static_cast<std::size_t>(sheet.BeachBase[i - sheet.rayPointCount()]);
      groupTime[i] = this->Surface->groupTime(of);
      brokenShare[i] = this->Surface->brokenShare(of);
    }
    this->Arrays.push_back(makeArray<vtkDoubleArray>("GroupTime", groupTime));
    this->Arrays.push_back(makeArray<vtkDoubleArray>("BrokenShare", brokenShare));
  }
}

}
