#ifndef ObstacleSource_h
#define ObstacleSource_h

#include "bathymetry/Georeference.h"
#include "sim/Obstacles.h"

#include <memory>
#include <string>
#include <vector>

class vtkDataObject;

namespace swellray
{

/** The obstacles of a scene, kept for as long as their file and the scene stay the same. */
class ObstacleField
{
public:
  /**
   * @param reflection coefficient of features that have none of their own, 0 to 1
   * @param bounds the scene, m
   * @throws as readObstacles()
   */
  std::shared_ptr<const Obstacles> get(
    const std::string& path, const Georeference& scene, const Rectangle& bounds, double reflection);

  /** The obstacles last got, as they were read, m. */
  const std::vector<Obstacle>& list() const { return this->List; }

  /** What a user should know about the obstacles last got, one line each. */
  const std::vector<std::string>& notes() const { return this->Notes; }

private:
  std::shared_ptr<const Obstacles> Kept;
  std::vector<Obstacle> List;
  std::vector<std::string> Notes;
  std::string Source;
};

/**
 * Put obstacles as field data: ObstaclePoints (double, 2 components, m), ObstacleOffsets (int, obstacles + 1: where
 * each begins), ObstacleRings (unsigned char: 1 a ring, 0 a line), ObstacleReflection and ObstacleSlope (double).
 */
void setObstacles(vtkDataObject* data, const std::vector<Obstacle>& obstacles);

/**
 * Obstacles of these field data; null where there are none.
 * @throws std::invalid_argument where they do not fit together
 */
std::shared_ptr<const Obstacles> obstaclesOf(vtkDataObject* data);

}

#endif
