#include "Pipeline.h"

#include "Failure.h"
#include "FieldValues.h"
#include "FilterRun.h"
#include "RayStarts.h"

#include "bathymetry/SeafloorReport.h"

#include <vtkAlgorithmOutput.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <filesystem>

namespace swellray::cli
{

Pipeline::Pipeline(const Request& request, Console& console)
  : Asked(request)
  , Screen(console)
{
  setUp(this->Reader, request.seafloor);
  setUp(this->Tracer, request.rays, request.seafloor.options.waterLevel);
  setUp(this->Heights, request.rays.height);
  setUp(this->Surface, request.surface);
  setUp(this->Foam, request.surface);
  setUp(this->FoamMap, request.surface);
  setUp(this->Seen, request.surface);
  setUp(this->Spray, request.surface);
  setUp(this->Probe, request.surface);
  for (const IncidentWave& wave : request.surface.components)
  {
    this->Components.push_back(std::make_unique<Component>());
    Component& component = *this->Components.back();
    RayRequest rays = request.rays;
    rays.wave.period = wave.period;
    rays.wave.directionFrom = wave.directionFrom;
    rays.wave.height = wave.height;
    setUp(component.tracer, rays, request.seafloor.options.waterLevel);
    setUp(component.heights, rays.height);
    component.tracer->SetInputConnection(this->Reader->GetOutputPort());
    component.heights->SetInputConnection(component.tracer->GetOutputPort());
  }
  for (const double level : request.contour.levels)
  {
    this->Contours->AddLevel(level);
  }
  this->Contours->SetInterval(request.contour.interval.value_or(0.0));
  this->Contours->SetSimplify(request.contour.simplify);
  this->Contours->SetRelief(request.contour.relief);
  this->Contours->SetInputConnection(this->Reader->GetOutputPort());
  this->Tracer->SetInputConnection(this->Reader->GetOutputPort());
  this->Heights->SetInputConnection(this->Tracer->GetOutputPort());
}

vtkSwellSeafloorReader* Pipeline::readSeafloor(Notes notes)
{
  try
  {
    runFilter(this->Reader, "reading", this->Screen);
  }
  catch (const WorkError& error)
  {
    if (this->Reader->GetErrorCode() == vtkErrorCode::UserError)
    {
      throw UsageError(error.what());
    }
    throw;
  }
  if (notes == Notes::Say)
  {
    const SeafloorReport& report = *this->Reader->GetReport();
    if (report.soundings)
    {
      this->Screen.say("soundings " + report.soundings->summary());
    }
    for (const std::string& note : report.notes)
    {
      this->Screen.say("note     " + note);
    }
  }
  return this->Reader;
}

vtkPolyData* Pipeline::makeContours(double waterLevel)
{
  this->Contours->SetWaterLevel(waterLevel);
  runFilter(this->Contours, "contours", this->Screen);
  return this->Contours->GetOutput();
}

void Pipeline::setWaterLevel(double level)
{
  this->Tracer->SetWaterLevel(level);
}

void Pipeline::takeLaunch()
{
  if (!this->Asked.start.launch.empty() && this->Tracer->GetNumberOfInputConnections(1) == 0)
  {
    const auto launch = readLaunch(this->Asked, georeferenceOf(this->Reader->GetOutput()));
    this->Tracer->SetInputData(1, launch);
    for (const auto& component : this->Components)
    {
      component->tracer->SetInputData(1, launch);
    }
  }
}

vtkPolyData* Pipeline::traceRays()
{
  this->takeLaunch();
  for (const auto& component : this->Components)
  {
    runFilter(component->tracer, "tracing", this->Screen);
  }
  runFilter(this->Tracer, "tracing", this->Screen);
  return this->Tracer->GetOutput();
}

vtkPolyData* Pipeline::computeHeights()
{
  for (const auto& component : this->Components)
  {
    runFilter(component->heights, "heights", this->Screen);
  }
  runFilter(this->Heights, "heights", this->Screen);
  return this->Heights->GetOutput();
}

vtkPolyData* Pipeline::makeCrests(vtkPolyData* rays)
{
  if (rays)
  {
    this->Crests->SetInputData(rays);
  }
  else
  {
    this->Crests->SetInputConnection(this->Heights->GetOutputPort());
    this->computeHeights();
  }
  this->Crests->MaxGapOfRaysOn();
  runFilter(this->Crests, "crests", this->Screen);
  return this->Crests->GetOutput();
}

vtkPolyData* Pipeline::makeBreakerLines()
{
  this->Breakers->SetInputConnection(this->Heights->GetOutputPort());
  this->Breakers->SetSeafloorConnection(this->Reader->GetOutputPort());
  this->Breakers->MaxGapOfRaysOn();
  runFilter(this->Breakers, "breakers", this->Screen);
  return this->Breakers->GetOutput();
}

std::vector<vtkAlgorithmOutput*> Pipeline::wavePorts() const
{
  std::vector<vtkAlgorithmOutput*> ports;
  if (this->Shared.empty())
  {
    ports.push_back(this->Heights->GetOutputPort());
    for (const auto& component : this->Components)
    {
      ports.push_back(component->heights->GetOutputPort());
    }
  }
  for (std::size_t i = 1; i < this->Shared.size(); ++i)
  {
    ports.push_back(this->Shared[i]->GetOutputPort());
  }
  return ports;
}

vtkAlgorithmOutput* Pipeline::seafloorPort() const
{
  return this->Shared.empty() ? this->Reader->GetOutputPort() : this->Shared.front()->GetOutputPort();
}

void Pipeline::shareWaves(const Pipeline& other)
{
  std::vector<vtkAlgorithmOutput*> ports = other.wavePorts();
  ports.insert(ports.begin(), other.seafloorPort());
  for (vtkAlgorithmOutput* port : ports)
  {
    auto producer = vtkSmartPointer<vtkTrivialProducer>::New();
    producer->SetOutput(port->GetProducer()->GetOutputDataObject(port->GetIndex()));
    // What this writes to the data is written before they have several readers.
    producer->Update();
    this->Shared.push_back(producer);
  }
}

void Pipeline::connectWaves(vtkAlgorithm* filter)
{
  if (filter->GetNumberOfInputConnections(0) > 0)
  {
    return;
  }
  for (vtkAlgorithmOutput* port : this->wavePorts())
  {
    filter->AddInputConnection(0, port);
  }
}

vtkPolyData* Pipeline::makeSurface(double time)
{
  this->connectWaves(this->Surface);
  this->Surface->SetSeafloorConnection(this->seafloorPort());
  this->Surface->SetTime(time);
  runFilter(this->Surface, "surface", this->Screen);
  this->Foam->SetInputConnection(this->Surface->GetOutputPort());
  runFilter(this->Foam, "foam", this->Screen);
  return this->Foam->GetOutput();
}

void Pipeline::seeBy(const scene::SceneCamera& camera, const std::array<int, 2>& size, int step)
{
  this->Seen->SetCameraPosition(camera.eye.data());
  this->Seen->SetCameraFocalPoint(camera.focus.data());
  this->Seen->SetCameraViewUp(camera.up.data());
  this->Seen->SetViewAngle(camera.angle);
  this->Seen->SetImageSize(size[0], size[1]);
  this->Seen->SetPixelStep(step);
}

vtkPolyData* Pipeline::makeSeenSurface(double time)
{
  this->connectWaves(this->Seen);
  this->Seen->SetSeafloorConnection(this->seafloorPort());
  this->Seen->SetTime(time);
  runFilter(this->Seen, "surface", this->Screen);
  return this->Seen->GetOutput();
}

vtkImageData* Pipeline::makeFoamMap(double time)
{
  this->connectWaves(this->FoamMap);
  this->FoamMap->SetSeafloorConnection(this->seafloorPort());
  this->FoamMap->SetTime(time);
  runFilter(this->FoamMap, "foam", this->Screen);
  return this->FoamMap->GetOutput();
}

void Pipeline::setProfile(const std::string& profile)
{
  this->Surface->SetSection(profile);
}

void Pipeline::setPointsPerWave(double points)
{
  this->Surface->SetPointsPerWave(points);
  this->Spray->SetPointsPerWave(points);
}

void Pipeline::setSpray(double rate, std::optional<double> scatter)
{
  this->Spray->SetRate(rate);
  this->Spray->SetScatter(scatter.value_or(this->Spray->GetScatter()));
}

vtkPolyData* Pipeline::makeSpray(double time)
{
  this->connectWaves(this->Spray);
  this->Spray->SetSeafloorConnection(this->seafloorPort());
  this->Spray->SetTime(time);
  runFilter(this->Spray, "spray", this->Screen);
  return this->Spray->GetOutput();
}

vtkPolyData* Pipeline::probeSurface(vtkPolyData* points)
{
  this->connectWaves(this->Probe);
  this->Probe->SetSeafloorConnection(this->seafloorPort());
  this->Probe->SetInputData(2, points);
  runFilter(this->Probe, "surface", this->Screen);
  return this->Probe->GetOutput();
}

std::vector<std::string> inputFiles(const Request& request)
{
  std::vector<std::string> files;
  for (const std::string& file : { request.seafloor.source, request.rays.current, request.rays.obstacles,
         request.start.launch, request.render.map, request.render.rays, request.render.crests, request.map.stations,
         request.map.waterLevels, request.spectrum.boundary, request.spectrum.series, request.surface.at })
  {
    std::error_code none;
    if (!file.empty() && std::filesystem::exists(file, none))
    {
      files.push_back(file);
    }
  }
  return files;
}

}
