#pragma once

#include "bathymetry/Soundings.h"

#include <optional>
#include <string>

namespace swellray
{

/**
 * Values on the nodes or the faces of an unstructured mesh in a NetCDF file that follows the UGRID conventions (1.0): a
 * variable with cf_role mesh_topology names the coordinates of the nodes and the nodes of each face. Values of faces lie
 * at the mesh's face_coordinates, otherwise at the faces' centroids.
 *
 * @param variable of the values; empty: the only one whose standard name is that of a seafloor, or the only one on the
 *   nodes, or the only one
 * @return nothing where the file is no NetCDF file or holds no such mesh
 * @throws std::runtime_error where it holds one that cannot be understood
 */
std::optional<Soundings> readUgridMesh(const std::string& path, const std::string& variable);

}
