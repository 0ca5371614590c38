#pragma once

#include "Options.h"
#include "OutputFile.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace swellray::cli
{

/** Endings of the files that lines can be written to. */
const std::vector<std::string>& lineEndings();

/** Options of such files. */
std::vector<OptionSpec> lineOptions(OutputRequest& output);

/** @throws UsageError where they fit none of the files */
void checkLines(const OutputRequest& output);

/** The program that opens a file. */
std::string viewerOf(const std::string& path);

/**
 * Write lines to the file's hidden name as its ending says: .vtp with the command line and the version, or a layer of
 * this name in a .gpkg or .geojson.
 * @param lines its cells are lines over its points in their order
 * @throws WorkError
 */
void writeLines(
  vtkPolyData* lines, const char* layer, const OutputFile& file, const Request& request, Console& console);

}
