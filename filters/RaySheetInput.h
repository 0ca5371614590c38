#ifndef RaySheetInput_h
#define RaySheetInput_h

#include "CausticField.h"
#include "ObstacleSource.h"
#include "RayArrays.h"
#include "sim/RayMap.h"

#include <vtkDataArray.h>

#include <memory>
#include <vector>

namespace swellray
{

/** Rays with heights as plain arrays, holding on to these. */
class SheetArrays
{
public:
  /**
   * @param rays output of vtkSwellWaveHeight
   * @throws std::invalid_argument naming the array that is missing
   */
  explicit SheetArrays(vtkPolyData* rays);
  SheetArrays(const SheetArrays&) = delete;
  void operator=(const SheetArrays&) = delete;

  const SheetRays& rays() const { return this->Rays; }

  /** Null where there are none. */
  const Obstacles* obstacles() const { return this->Walls.get(); }

private:
  std::vector<std::int64_t> Offsets;
  std::vector<vtkSmartPointer<vtkDataArray>> Held;
  std::shared_ptr<const Obstacles> Walls;
  std::vector<RayCaustic> Touched;
  SheetRays Rays;
};

/** The sheets of rays with heights, holding on to their arrays. */
class RaySheetInput
{
public:
  /** @throws std::invalid_argument as SheetArrays; std::runtime_error as RaySheets */
  explicit RaySheetInput(vtkPolyData* rays);

  const RaySheets& sheets() const { return this->Sheets; }

  /** Depths at places, m, with 0 for those on the land inside of obstacles: rays bring no wave there. */
  std::vector<double> wetDepths(const std::vector<glm::dvec2>& places, const double* depths) const;

private:
  SheetArrays Arrays;
  RaySheets Sheets;
};

/** Add the arrays of a map, under the names that vtkSwellMap lists. */
void addMapArrays(vtkFieldData* attributes, const RayMap& map);

}

#endif
