#ifndef SurfaceWaves_h
#define SurfaceWaves_h

#include "SurfaceScene.h"
#include "sim/SurfaceSum.h"

#include <cstddef>
#include <memory>
#include <vector>

class vtkInformationVector;

namespace swellray
{

/** The waves of a sea, each of its own rays, kept as long as their scenes stay the same. */
class SurfaceWaves
{
public:
  /**
   * Take the rays that are connected to a port from the connection `first` on.
   * @throws std::invalid_argument as SurfaceScene; where waves have different water levels
   */
  void update(vtkInformationVector* port, int first, vtkImageData* image, vtkDataArray* elevation,
    SeafloorField& seafloor, const SurfaceScene::Settings& settings, vtkAlgorithm* algorithm);

  /** Their sum; null where there are none. */
  const SurfaceSum* sum() const { return this->Sum.get(); }

  /** Each of them. */
  std::vector<const SurfaceFunction*> functions() const;

  /** What each is made of. */
  std::vector<std::shared_ptr<const SurfaceScene>> scenes() const;

  /** Grows when the waves become others: what was made of them is to be made again. */
  std::size_t version() const { return this->Version; }

private:
  struct Wave
  {
    std::shared_ptr<const SurfaceScene> scene;
    std::unique_ptr<const SurfaceFunction> function;
  };

  std::vector<Wave> Waves;
  std::unique_ptr<const SurfaceSum> Sum;
  std::size_t Version = 0;
};

}

#endif
