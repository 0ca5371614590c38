#include "WaveModel.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace swellray::view
{

namespace
{

// Rays of recent settings are kept up to so many points, some hundred megabytes.
constexpr vtkIdType MostKeptPoints = 2000000;

// Rays over the longer side of the scene for the very first trace, of which nothing is known.
constexpr double FirstRays = 100.0;

// A coarse trace is looked at for a moment only.
constexpr double CoarseTolerance = 1e-6;
constexpr double CoarseFronts = 2.0; // a wavelength

// A ray that is further from a place than so many times the threshold of insertion did not come there.
constexpr double GapOverMaxSpacing = 2.0;

double fieldNumber(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : 0.0;
}

// "ERROR: In file, line n\nvtkClass (0x...): words\n\n" to the words, on one line.
std::string wordsOf(const std::string& message)
{
  const auto mark = message.find("): ");
  std::string words = mark == std::string::npos ? message : message.substr(mark + 3);
  while (!words.empty() && (words.back() == '\n' || words.back() == ' '))
  {
    words.pop_back();
  }
  std::replace(words.begin(), words.end(), '\n', ' ');
  return words;
}

// Keeps the first error, and ends the filter when it is no longer needed.
class Watch : public vtkCommand
{
public:
  static Watch* New() { return new Watch; }

  void Execute(vtkObject* caller, unsigned long event, void* data) override
  {
    if (event == vtkCommand::ErrorEvent && this->Error.empty())
    {
      this->Error = wordsOf(static_cast<const char*>(data));
    }
    if (event == vtkCommand::ProgressEvent && this->IsOutdated())
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
  }

  std::string Error;
  std::function<bool()> IsOutdated;
};

vtkSmartPointer<vtkPolyData> copyOf(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(data);
  return copy;
}

vtkIdType pointsOf(const TracedWaves& waves)
{
  return waves.rays ? waves.rays->GetNumberOfPoints() : 0;
}

}

WaveModel::WaveModel(const Setup& setup)
  : MostSurfacePoints(setup.mostSurfacePoints)
  , Steps(setup.frame)
{
  // The arrays are shared and only read; the rest of the image is the worker's own.
  this->Seafloor->ShallowCopy(setup.seafloor);
  setup.tracer(this->Tracer);
  setup.heights(this->Heights);
  setup.surface(this->Sea, this->Foam);
  this->SetSpacing =
    this->Tracer->GetSpacing() > 0.0 ? std::optional<double>(this->Tracer->GetSpacing()) : std::nullopt;
  this->Tolerance = this->Tracer->GetTolerance();
  double bounds[6];
  this->Seafloor->GetBounds(bounds);
  this->FinestSpacing = this->SetSpacing.value_or(std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]) / FirstRays);
  this->FinestFronts = this->Tracer->GetStepsPerWave();
  this->Tracer->SetInputData(this->Seafloor);
  this->Tracer->LongitudeLatitudeOff();
  this->Heights->SetInputConnection(this->Tracer->GetOutputPort());
  this->Crests->MaxGapOfRaysOn();
  this->Sea->SetInputData(1, this->Seafloor);
  this->Foam->SetInputConnection(this->Sea->GetOutputPort());
  this->Stations->SetInputData(1, this->Seafloor);
  this->Worker = std::thread([this] { this->work(); });
}

WaveModel::~WaveModel()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Stopped = true;
  }
  this->Call.notify_all();
  this->Worker.join();
}

void WaveModel::setControls(const WaveControls& controls)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Generation > 0 && controls == this->Controls)
  {
    return;
  }
  this->Controls = controls;
  this->Asked.controls = controls;
  ++this->Generation;
  this->Call.notify_all();
}

void WaveModel::requestSurface(double time)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Asked.surface = time;
  this->Call.notify_all();
}

void WaveModel::requestWavesAt(double x, double y)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Asked.place = { x, y };
  this->Call.notify_all();
}

WaveModel::News WaveModel::poll()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  News news;
  if (this->DoneWaves)
  {
    this->Waves = *this->DoneWaves;
    this->DoneWaves.reset();
    news.waves = true;
  }
  if (this->DoneSurface)
  {
    this->Surface = *this->DoneSurface;
    this->DoneSurface.reset();
    news.surface = true;
  }
  if (this->DonePlace)
  {
    this->Place = *this->DonePlace;
    this->DonePlace.reset();
    news.wavesAt = true;
  }
  return news;
}

bool WaveModel::isRefined() const
{
  return this->Generation > 0 && this->Waves.controls == this->Controls && this->Waves.coarseness == 1 &&
    (this->Waves.rays || !this->Waves.failure.empty());
}

bool WaveModel::isOutdated() const
{
  return this->Stopped || (this->GivesUp && this->Generation != this->TracedGeneration);
}

bool WaveModel::isWaiting() const
{
  return !this->Stopped && this->Generation == this->TracedGeneration && this->Current.coarseness == 1 &&
    !this->Asked.surface && !this->Asked.place;
}

void WaveModel::work()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  while (true)
  {
    this->Call.wait(lock, [this] { return !this->isWaiting(); });
    if (this->Stopped)
    {
      return;
    }
    const bool isNew = this->Generation != this->TracedGeneration;
    this->TracedGeneration = this->Generation;
    // The first trace of a setting is short, and must be seen while the slider moves on: the rest is given up then.
    this->GivesUp = !isNew;
    const Wanted asked = this->Asked;
    const bool places = !isNew && asked.place;
    // A moving sea is made of the finest rays only.
    const bool refines = !isNew && !places && this->Current.coarseness > 1;
    const bool moves = !isNew && !places && !refines;
    if (places)
    {
      this->Asked.place.reset();
    }
    if (moves)
    {
      this->Asked.surface.reset();
    }
    lock.unlock();
    if (isNew)
    {
      const TracedWaves* known = this->kept(asked.controls);
      this->publish(known ? *known : this->trace(asked.controls, this->Steps.first()));
    }
    else if (places)
    {
      const WavesAt place = this->lookUp(this->Current, asked.place->first, asked.place->second);
      const std::lock_guard<std::mutex> done(this->Mutex);
      this->DonePlace = place;
    }
    else if (refines)
    {
      const TracedWaves finer = this->trace(asked.controls, this->Steps.next(this->Current.coarseness));
      if (!this->isOutdated())
      {
        this->publish(finer);
      }
    }
    else if (moves && asked.surface)
    {
      const SurfaceFrame frame = this->makeSurface(this->Current, *asked.surface);
      const std::lock_guard<std::mutex> done(this->Mutex);
      if (!this->isOutdated())
      {
        this->DoneSurface = frame;
      }
    }
    lock.lock();
  }
}

std::string WaveModel::run(vtkAlgorithm* filter)
{
  vtkNew<Watch> watch;
  watch->IsOutdated = [this] { return this->isOutdated(); };
  const unsigned long observers[] = { filter->AddObserver(vtkCommand::ErrorEvent, watch),
    filter->AddObserver(vtkCommand::WarningEvent, watch), filter->AddObserver(vtkCommand::ProgressEvent, watch) };
  filter->Update();
  for (const unsigned long observer : observers)
  {
    filter->RemoveObserver(observer);
  }
  return watch->Error;
}

TracedWaves WaveModel::trace(const WaveControls& controls, int coarseness)
{
  TracedWaves waves;
  waves.controls = controls;
  waves.coarseness = coarseness;
  this->Tracer->SetPeriod(controls.period);
  this->Tracer->SetDirectionFrom(controls.directionFrom);
  this->Tracer->SetWaveHeight(controls.height);
  this->Tracer->SetWaterLevel(controls.waterLevel);
  const bool finest = coarseness == 1;
  this->Tracer->SetSpacing(finest ? this->SetSpacing.value_or(0.0) : coarseness * this->FinestSpacing);
  this->Tracer->SetTolerance(finest ? this->Tolerance : std::max(this->Tolerance, CoarseTolerance));
  this->Tracer->SetStepsPerWave(finest ? this->FinestFronts : CoarseFronts);
  const auto start = std::chrono::steady_clock::now();
  waves.failure = this->run(this->Tracer);
  if (waves.failure.empty() && !this->isOutdated())
  {
    waves.failure = this->run(this->Heights);
  }
  waves.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!waves.failure.empty())
  {
    waves.coarseness = 1; // finer rays would meet the same
    return waves;
  }
  if (this->isOutdated())
  {
    return waves;
  }
  waves.rays = copyOf(this->Heights->GetOutput());
  this->FinestSpacing = fieldNumber(waves.rays, "LaunchSpacing") / coarseness;
  this->Steps.learn(coarseness, waves.seconds);
  this->Crests->SetInputData(waves.rays);
  if (this->run(this->Crests).empty())
  {
    waves.crests = copyOf(this->Crests->GetOutput());
  }
  return waves;
}

void WaveModel::publish(const TracedWaves& waves)
{
  this->Current = waves;
  if (waves.coarseness == 1)
  {
    this->keep(waves);
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->DoneWaves = waves;
}

void WaveModel::keep(const TracedWaves& waves)
{
  this->Kept.remove_if([&](const TracedWaves& other) { return other.controls == waves.controls; });
  this->Kept.push_front(waves);
  vtkIdType points = pointsOf(waves);
  auto last = std::next(this->Kept.begin());
  while (last != this->Kept.end() && (points += pointsOf(*last)) <= MostKeptPoints)
  {
    ++last;
  }
  this->Kept.erase(last, this->Kept.end());
}

const TracedWaves* WaveModel::kept(const WaveControls& controls) const
{
  const auto found = std::find_if(
    this->Kept.begin(), this->Kept.end(), [&](const TracedWaves& waves) { return waves.controls == controls; });
  return found == this->Kept.end() ? nullptr : &*found;
}

SurfaceFrame WaveModel::makeSurface(const TracedWaves& waves, double time)
{
  SurfaceFrame frame;
  frame.time = time;
  if (!waves.rays)
  {
    frame.failure = waves.failure;
    return frame;
  }
  // The sheet has at least as many points as the rays.
  if (waves.rays->GetNumberOfPoints() > this->MostSurfacePoints)
  {
    frame.failure = "too many waves in this scene for a moving sea: take a part of it with --crop";
    return frame;
  }
  this->Sea->SetInputData(0, waves.rays);
  this->Sea->SetTime(time);
  frame.failure = this->run(this->Sea);
  if (frame.failure.empty() && !this->isOutdated())
  {
    frame.failure = this->run(this->Foam);
  }
  if (frame.failure.empty() && !this->isOutdated())
  {
    frame.surface = copyOf(this->Foam->GetOutput());
  }
  return frame;
}

WavesAt WaveModel::lookUp(const TracedWaves& waves, double x, double y)
{
  constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();
  WavesAt at{ x, y, Unknown, Unknown, Unknown, Unknown, Unknown, Unknown, -1, Unknown, Unknown, Unknown };
  if (!waves.rays)
  {
    return at;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(x, y, 0.0);
  vtkNew<vtkPolyData> place;
  place->SetPoints(points);
  this->Stations->SetInputData(0, waves.rays);
  this->Stations->SetInputData(2, place);
  if (!this->run(this->Stations).empty())
  {
    return at;
  }
  vtkPointData* values = this->Stations->GetOutput()->GetPointData();
  const auto value = [&](const char* name)
  {
    vtkDataArray* array = values->GetArray(name);
    return array ? array->GetComponent(0, 0) : Unknown;
  };
  at.elevation = value("Elevation");
  at.depth = value("Depth");
  at.height = value("WaveHeight");
  if (!std::isfinite(at.height))
  {
    return at;
  }
  at.directionFrom = value("DirectionFrom");
  at.wavelength = value("Wavelength");
  at.period = waves.controls.period;
  double nearest = std::max(GapOverMaxSpacing * fieldNumber(waves.rays, "MaxSpacing"), at.wavelength);
  vtkIdType point = -1;
  for (vtkIdType ray = 0; ray < waves.rays->GetNumberOfCells(); ++ray)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    waves.rays->GetCellPoints(ray, count, ids);
    for (vtkIdType i = 0; i < count; ++i)
    {
      double p[3];
      waves.rays->GetPoint(ids[i], p);
      const double distance = std::hypot(p[0] - x, p[1] - y);
      if (distance < nearest)
      {
        nearest = distance;
        at.ray = ray;
        point = ids[i];
      }
    }
  }
  if (point >= 0)
  {
    vtkPointData* data = waves.rays->GetPointData();
    at.refraction = data->GetArray("RefractionCoefficient")->GetComponent(point, 0);
    at.shoaling = data->GetArray("ShoalingCoefficient")->GetComponent(point, 0);
    at.travelTime = data->GetArray("TravelTime")->GetComponent(point, 0);
  }
  return at;
}

}
