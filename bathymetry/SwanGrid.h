#pragma once

#include "bathymetry/ModelGrid.h"

#include <functional>
#include <string>

namespace swellray
{

/** The text of a file that another one names. */
using FileText = std::function<std::string(const std::string& name)>;

/**
 * The bottom grid of a SWAN run, from its command file (SWAN user manual 41.45, commands CGRID, INPGRID, READGRID and
 * READINP): regular, which may be rotated, or curvilinear with the coordinates of READGRID. Values are depths, positive
 * down, times [fac]; all six layouts [idla], header lines and free format are read. Nodes with the exception value take
 * no part in a SWAN run: they are land, taken 5 m above the datum or as high as the highest node where that is higher.
 * COORDINATES SPHERICAL means longitude and latitude.
 *
 * @param commands text of the command file
 * @param open text of the files that it names
 * @throws std::runtime_error where the bottom is unstructured, a series in time, written in a fixed or binary format,
 *   or not given, or where values are missing
 */
ModelGrid readSwanGrid(const std::string& commands, const FileText& open);

}
