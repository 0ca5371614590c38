#include "SurfaceWaves.h"

#include <vtkInformationVector.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace swellray
{

void SurfaceWaves::update(vtkInformationVector* port, int first, vtkImageData* image, vtkDataArray* elevation,
  SeafloorField& seafloor, const SurfaceScene::Settings& settings, vtkAlgorithm* algorithm)
{
  const int connections = port->GetNumberOfInformationObjects();
  std::vector<Wave> waves;
  std::vector<const SurfaceFunction*> functions;
  bool same = static_cast<std::size_t>(std::max(0, connections - first)) == this->Waves.size();
  for (int i = first; i < connections; ++i)
  {
    const auto at = static_cast<std::size_t>(i - first);
    Wave wave;
    wave.scene = SurfaceScene::of(vtkPolyData::GetData(port, i), image, elevation, seafloor, settings, algorithm);
    const bool kept = at < this->Waves.size() && this->Waves[at].scene == wave.scene;
    same = same && kept;
    wave.function =
      kept ? std::move(this->Waves[at].function) : std::make_unique<const SurfaceFunction>(wave.scene->surface());
    functions.push_back(wave.function.get());
    waves.push_back(std::move(wave));
  }
  this->Waves = std::move(waves);
  if (!same || !this->Sum)
  {
    ++this->Version;
    this->Sum.reset();
    this->Sum = functions.empty() ? nullptr : std::make_unique<const SurfaceSum>(functions);
  }
}

std::vector<std::shared_ptr<const SurfaceScene>> SurfaceWaves::scenes() const
{
  std::vector<std::shared_ptr<const SurfaceScene>> scenes;
  for (const Wave& wave : this->Waves)
  {
    scenes.push_back(wave.scene);
  }
  return scenes;
}

std::vector<const SurfaceFunction*> SurfaceWaves::functions() const
{
  std::vector<const SurfaceFunction*> functions;
  for (const Wave& wave : this->Waves)
  {
    functions.push_back(wave.function.get());
  }
  return functions;
}

}
