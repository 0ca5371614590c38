#ifndef RaySheetInput_h
#define RaySheetInput_h

#include "ObstacleSource.h"
#include "RayArrays.h"
#include "sim/RayMap.h"

#include <vtkDataArray.h>

#include <memory>
#include <vector>

namespace swellray
{

/** The sheets of rays with heights, holding on to their arrays. */
class RaySheetInput
{
public:
  /**
   * @param rays output of vtkSwellWaveHeight
   * @throws std::invalid_argument naming the array that is missing; std::runtime_error as RaySheets
   */
  explicit RaySheetInput(vtkPolyData* rays);

  const RaySheets& sheets() const { return *this->Sheets; }

  /** Depths at places, m, with 0 for those on the land inside of obstacles: rays bring no wave there. */
  std::vector<double> wetDepths(const std::vector<glm::dvec2>& places, const double* depths) const;

private:
  std::vector<std::int64_t> Offsets;
  std::vector<vtkSmartPointer<vtkDataArray>> Held;
  std::shared_ptr<const Obstacles> Walls;
  std::unique_ptr<RaySheets> Sheets;
};

/** Add the arrays of a map, under the names that vtkSwellMap lists. */
void addMapArrays(vtkFieldData* attributes, const RayMap& map);

}

#endif
