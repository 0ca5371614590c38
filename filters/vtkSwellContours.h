#ifndef vtkSwellContours_h
#define vtkSwellContours_h

#include "swellrayFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <vector> // for the levels

/**
 * @class   vtkSwellContours
 * @brief   depth contour lines of a seafloor
 *
 * Marching squares by vtkFlyingEdges2D; crossings on the edges of the grid are linear between the nodes, in double
 * precision. The depth is WaterLevel less the elevation, m, positive in water.
 *
 * Input 0: vtkImageData with one layer of nodes, axes east and north, point array Elevation (m, positive up, NaN: a
 * hole). No line enters a cell that touches a hole: it ends there.
 *
 * Output: one poly-line a contour, as long as it goes, its points at z = 0. A closed contour ends with its first point.
 * Shallower water (a smaller depth) lies on the LEFT of the line's direction, seen from above.
 * - cell array Depth (double, m)
 * - point arrays Longitude, Latitude (degrees) where the input says how to map back
 * - the field data of the input, and WaterLevel (m).
 */
class SWELLRAYFILTERS_EXPORT vtkSwellContours : public vtkPolyDataAlgorithm
{
public:
  static vtkSwellContours* New();
  vtkTypeMacro(vtkSwellContours, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Depths to draw, m; may be negative (land). Default none: by Interval. */
  void AddLevel(double depth);
  void ClearLevels();
  int GetNumberOfLevels() const { return static_cast<int>(this->Levels.size()); }
  double GetLevel(int i) const { return this->Levels.at(static_cast<std::size_t>(i)); }
  ///@}

  ///@{
  /**
   * Without levels: draw the multiples of this depth from 0, the shoreline, to the deepest point, m; > 0.
   * Default 0: 1, 2 or 5 times a power of ten that gives at most ten lines below the shoreline.
   */
  vtkSetMacro(Interval, double);
  vtkGetMacro(Interval, double);
  ///@}

  ///@{
  /** Still-water level (tide), m, positive up, in the datum of the elevations; default 0. */
  vtkSetMacro(WaterLevel, double);
  vtkGetMacro(WaterLevel, double);
  ///@}

  ///@{
  /**
   * Ground that nowhere departs from a level by this much gets no line of its own, m; >= 0, default 0.02. Flats that
   * are stored as just this level lie on the shallower side.
   */
  vtkSetMacro(Relief, double);
  vtkGetMacro(Relief, double);
  ///@}

  ///@{
  /** Leave out points as long as lines stay this near to where they were and do not cross, m; >= 0, default 0: none. */
  vtkSetMacro(Simplify, double);
  vtkGetMacro(Simplify, double);
  ///@}

protected:
  vtkSwellContours();
  ~vtkSwellContours() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  std::vector<double> Levels;
  double Interval = 0.0;
  double WaterLevel = 0.0;
  double Relief = 0.02;
  double Simplify = 0.0;

private:
  vtkSwellContours(const vtkSwellContours&) = delete;
  void operator=(const vtkSwellContours&) = delete;
};

#endif
