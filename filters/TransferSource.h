#ifndef TransferSource_h
#define TransferSource_h

#include "bathymetry/TransferFile.h"
#include "sim/BackwardTracer.h"
#include "sim/Execution.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace swellray
{

/** What backward rays over a seafloor depend on, for TransferTable. The bed and the current count by their values. */
std::vector<std::string> describeScene(vtkImageData* seafloor, vtkDataArray* elevation, const BackwardOptions& options,
  std::size_t frequencies, std::size_t directions, std::size_t perDirection);

/** The table of a file; an empty one where there is no such file. @throws std::runtime_error where it is damaged */
TransferTable readTransferTableIfThere(const std::string& file);

/**
 * Trace what a table lacks of these places, and leave in it just these, in their order. The file, where one is named, gets
 * all places of the table and the new ones, every 20 s and at the end, also after a cancel.
 * @throws std::runtime_error where the table is of another scene, or cannot be written
 */
void completeTransferTable(const std::string& file, TransferTable& table, const std::vector<std::string>& scene,
  const SpectralRays& rays, const BackwardTracer& tracer, const std::vector<glm::dvec2>& places,
  const Execution& execution, const std::string& history);

}

#endif
