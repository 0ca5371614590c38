#ifndef SeafloorField_h
#define SeafloorField_h

#include "sim/ElevationGrid.h"

#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>

class vtkImageData;

namespace swellray
{

/**
 * Elevations of an image as a grid.
 * @throws std::invalid_argument unless the image is one layer with axes east and north and `elevation` one number a node
 */
ElevationGrid gridOfImage(vtkImageData* image, vtkDataArray* elevation);

/** Seafloor of an image as a function, kept for as long as the image stays the same. */
class SeafloorField
{
public:
  /**
   * The formula named by the field data SeafloorForm, cut to the extent of the image, where its elevations are those
   * of the image; otherwise the spline through the elevations.
   * @throws std::invalid_argument as gridOfImage, as SplineSeafloor, or where the form is not known
   */
  std::shared_ptr<const Seafloor> get(vtkImageData* image, vtkDataArray* elevation);

private:
  std::shared_ptr<const Seafloor> Kept;
  vtkSmartPointer<vtkDataArray> Elevation; // held, so that no other array can take its address
  vtkMTimeType ElevationTime = 0;
  Rectangle Bounds;
  std::string Form;
};

}

#endif
