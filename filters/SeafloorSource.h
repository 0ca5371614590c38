#ifndef SeafloorSource_h
#define SeafloorSource_h

#include "bathymetry/SeafloorReader.h"

#include <string>

namespace swellray
{

/** A seafloor as vtkSwellSeafloorReader hands it on. */
struct SeafloorScene
{
  Bathymetry bathymetry;
  std::string form; ///< spec of a built-in form whose formula holds between the nodes of the grid; otherwise empty
};

/**
 * Seafloor of a built-in form (`NAME:key=value,...`), an image file (.vti, point array Elevation, m, positive up), a VTK
 * grid or mesh (loadMesh()), or any file that readSeafloor() reads.
 *
 * A form is sampled at 500 nodes along its longer side, or at `resample`; crop is in its own coordinates. Options that
 * say how a file is to be understood (positive, crs, nodata, variable) are refused with a form.
 *
 * @throws std::invalid_argument an option or form out of range
 * @throws std::runtime_error a file that cannot be read or understood
 */
SeafloorScene loadSeafloor(const std::string& name, const SeafloorOptions& options, const Execution& execution = {});

}

#endif
