// What the window does while a slider moves: rays and heights of another wave over a seafloor that is there.
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSwellFoam.h>
#include <vtkSwellRayTracer.h>
#include <vtkSwellSeafloorReader.h>
#include <vtkSwellSurface.h>
#include <vtkSwellWaveHeight.h>

#include <benchmark/benchmark.h>

namespace
{

constexpr double Frame = 1.0 / 60.0; // s

struct Bay
{
  Bay()
  {
    this->Reader->SetFileName("bay");
    this->Tracer->SetInputConnection(this->Reader->GetOutputPort());
    this->Tracer->SetPeriod(3.0);
    this->Tracer->SetDirectionFrom(90.0);
    this->Tracer->SetWaveHeight(0.4);
    this->Tracer->LongitudeLatitudeOff();
    this->Heights->SetInputConnection(this->Tracer->GetOutputPort());
    this->Heights->Update();
  }

  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellRayTracer> Tracer;
  vtkNew<vtkSwellWaveHeight> Heights;
};

// The counter `frames` is how many frames of 1/60 s one trace takes: below 1 the rays follow the slider frame by frame.
// The CPU time is that of all threads, and stays the same on a machine that is busy.
void rays(benchmark::State& state)
{
  vtkSMPTools::Initialize(static_cast<int>(state.range(0)));
  Bay bay;
  double direction = 90.0;
  for (auto _ : state)
  {
    direction = direction == 90.0 ? 91.0 : 90.0;
    bay.Tracer->SetDirectionFrom(direction);
    bay.Heights->Update();
    benchmark::DoNotOptimize(bay.Heights->GetOutput());
  }
  using benchmark::Counter;
  state.counters["rays"] = static_cast<double>(bay.Heights->GetOutput()->GetNumberOfCells());
  state.counters["frames"] =
    Counter(static_cast<double>(state.iterations()) * Frame, Counter::kIsRate | Counter::kInvert);
}

void surface(benchmark::State& state)
{
  vtkSMPTools::Initialize(static_cast<int>(state.range(0)));
  Bay bay;
  vtkNew<vtkSwellSurface> sea;
  sea->SetInputConnection(0, bay.Heights->GetOutputPort());
  sea->SetSeafloorConnection(bay.Reader->GetOutputPort());
  vtkNew<vtkSwellFoam> foam;
  foam->SetInputConnection(sea->GetOutputPort());
  double time = 0.0;
  for (auto _ : state)
  {
    sea->SetTime(time += Frame);
    foam->Update();
    benchmark::DoNotOptimize(foam->GetOutput());
  }
  using benchmark::Counter;
  state.counters["points"] = static_cast<double>(foam->GetOutput()->GetNumberOfPoints());
  state.counters["frames"] =
    Counter(static_cast<double>(state.iterations()) * Frame, Counter::kIsRate | Counter::kInvert);
}

BENCHMARK(rays)
  ->Name("View/bay/rays")
  ->ArgName("threads")
  ->Arg(1)
  ->Arg(2)
  ->MeasureProcessCPUTime()
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK(surface)
  ->Name("View/bay/surface")
  ->ArgName("threads")
  ->Arg(1)
  ->Arg(2)
  ->MeasureProcessCPUTime()
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);

}
