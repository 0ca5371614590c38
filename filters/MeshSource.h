#ifndef MeshSource_h
#define MeshSource_h

#include "bathymetry/SeafloorReader.h"

#include <string>

namespace swellray
{

/**
 * A seafloor from a VTK file of points: a structured grid of one layer (.vts) or an unstructured grid (.vtu) of which
 * the cells in two dimensions (triangles, quadrilaterals, polygons, pixels) are the seafloor; without such cells, its
 * points are soundings. Elevations (m, positive up) are the point array Elevation, otherwise the points' z. Points are
 * in the metres of the georeference in the field data, as in every file that Swellray writes. Read further as grids and
 * meshes of models are (readSeafloor()).
 * @throws std::runtime_error a file that cannot be read or understood
 */
Bathymetry loadMesh(const std::string& path, const SeafloorOptions& options, const Execution& execution);

}

#endif
