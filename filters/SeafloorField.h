#ifndef SeafloorField_h
#define SeafloorField_h

#include "sim/ElevationGrid.h"

#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <optional>
#include <string>

class vtkDataObject;
class vtkImageData;

namespace swellray
{

/**
 * Elevations of an image as a grid.
 * @throws std::invalid_argument unless the image is one layer with axes east and north and `elevation` one number a node
 */
ElevationGrid gridOfImage(vtkImageData* image, vtkDataArray* elevation);

/**
 * Put the nodes of a grid in degrees as field data of the image that shows it on the map: GeographicElevation (double),
 * and GeographicGrid: columns, rows, first longitude and latitude, and their steps.
 */
void setGeographicGrid(vtkImageData* image, const ElevationGrid& grid);

/** The grid that setGeographicGrid() put there; none where there is none that is whole. */
std::optional<ElevationGrid> geographicGridOf(vtkImageData* image);

/** Take that grid away from what a pipeline has handed on: it belongs to the seafloor alone. */
void dropGeographicGrid(vtkDataObject* data);

/** Seafloor of an image as a function, kept for as long as the image stays the same. */
class SeafloorField
{
public:
  /**
   * The formula named by the field data SeafloorForm, cut to the extent of the image, or the spline of the grid in degrees
   * that goes with an image on the ellipsoid, where its elevations are those of the image; otherwise the spline through
   * the elevations.
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
