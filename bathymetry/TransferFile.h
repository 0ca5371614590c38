#pragma once

#include "sim/SpectralTransfer.h"

#include <string>
#include <vector>

namespace swellray
{

/** Rays traced back from places over one scene, which any sea offshore can be brought along. */
struct TransferTable
{
  /** What the rays depend on, "name value" an entry, in an order of their own. */
  std::vector<std::string> scene;
  SpectralRays rays;
  std::vector<SpectralOrigins> places;
};

/**
 * Write a table as NetCDF-4: dimensions place, frequency and direction (all rays); x, y (m, in the scene's plane) and depth
 * of the places, frequency (Hz), direction (nautical degrees at the place, coming from), and for each ray offshore_direction
 * (nautical degrees, NaN where no wave comes from offshore) and gain (E at the place over E offshore). The file appears
 * whole or not at all.
 * @param history how it was made
 * @throws std::runtime_error naming the file and the reason
 */
void writeTransferTable(const std::string& path, const TransferTable& table, const std::string& history);

/** Name under which writeTransferTable() writes a file until it is whole: that of a hidden file beside it. */
std::string transferTablePart(const std::string& path);

/** @throws std::runtime_error naming the file and what is wrong with it */
TransferTable readTransferTable(const std::string& path);

/**
 * Check that a table was made over a scene.
 * @throws std::runtime_error naming the file and the first entry that differs
 */
void requireScene(const std::string& path, const TransferTable& table, const std::vector<std::string>& scene);

}
