#pragma once

#include "Options.h"

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkDataSet;

namespace swellray::cli
{

class OutputFile;

/** True for the name of a series, .pvd. */
bool isSeries(const std::string& file);

/** Write data as .vtp, a grid as .vti, .nc or .tif by the file's ending. @throws WorkError */
void writeFrame(vtkDataSet* data, const OutputFile& file, const Request& request, Console& console);

/** A series on its way: its file, beside which a folder of the same name has the frames, and what makes a frame. */
struct FrameSeries
{
  OutputFile* file = nullptr;
  std::function<vtkDataSet*(std::size_t, double)> make;    ///< the data at a time, s, by a worker
  const char* ending = ".vtp";                             ///< of its frames: .vti for grids
  std::vector<std::pair<double, std::string>> frames = {}; ///< that there are: time and file
};

/**
 * Write series of frames. Whole frames of the very same call that are there are kept.
 * @param workers that make frames at the same time, each on a thread of its own where there are several; files and their
 *   bytes do not depend on how many
 * @param said called with the first frame that is made
 * @throws WorkError
 */
void writeFrames(std::vector<FrameSeries>& all, const TimeSeries& times, const Request& request, Console& console,
  std::size_t workers, const std::function<void(vtkDataSet*)>& said);

/** Workers that are worth their memory for so many frames. */
std::size_t frameWorkers(std::size_t frames);

}
