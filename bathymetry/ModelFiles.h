#pragma once

#include "bathymetry/ModelGrid.h"

#include <optional>
#include <string>

namespace swellray
{

/**
 * The grid of a wave or flow model by the file that names the rest of it:
 * - SWAN: the command file, .swn (readSwanGrid())
 * - XBeach: params.txt (readXbeachGrid())
 * - STWAVE: .sim (readStwaveGrid())
 * - Delft3D: .mdf, or .grd with the .dep file of the same name, or the only one, beside it (readDelft3dGrid()), or as
 *   the params.txt beside it says, where that names it
 * - matrices of z, x and y: z_NAME.grd or NAME_z.dep with the same name in x and y beside it (readMatrixGrid())
 * - a survey table of the Field Research Facility: .grid (readFrfTable())
 * - Celeris: a .txt matrix with its configuration, a .json file beside it that has its size (readCelerisGrid())
 *
 * Files that it names are looked for in its folder, a name with \ as one with /.
 *
 * @return nothing where the file is of another kind
 * @throws std::runtime_error where it is a model's and cannot be understood, or holds values of which another file
 *   says where they lie; the message says which
 */
std::optional<ModelGrid> readModelGrid(const std::string& path);

}
