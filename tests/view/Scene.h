#pragma once

#include "apps/view/WaveModel.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSwellSeafloorReader.h>

#include <chrono>
#include <functional>
#include <string>
#include <thread>

/** A built-in seafloor, and the set-up of a model of it. */
class Scene
{
public:
  explicit Scene(const std::string& form)
  {
    this->Reader->SetFileName(form.c_str());
    this->Reader->Update();
  }

  swellray::view::WaveModel::Setup setup() const
  {
    swellray::view::WaveModel::Setup setup;
    setup.seafloor = this->Reader->GetOutput();
    setup.tracer = [](vtkSwellRayTracer*) {};
    setup.heights = [](vtkSwellWaveHeight*) {};
    setup.surface = [](vtkSwellSurface*, vtkSwellFoam*) {};
    return setup;
  }

private:
  vtkNew<vtkSwellSeafloorReader> Reader;
};

/** Let time pass until something holds; false where it does not within so long that it never will. */
inline bool waitUntil(const std::function<bool()>& holds)
{
  constexpr int LongestWait = 60; // s
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(LongestWait);
  while (!holds())
  {
    if (std::chrono::steady_clock::now() > end)
    {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}
