#pragma once

#include "bathymetry/SpectrumFile.h"

#include <string>

// The formats of spectral files, one reader each; readSpectra() chooses.
namespace swellray
{

SpectrumFile readSwanSpectra(const std::string& path);

/** Spectra of NetCDF: CF, WAVEWATCH III. */
SpectrumFile readNetcdfSpectra(const std::string& path);

/** Spectra of a buoy of NDBC: densities, and beside them the files of directions and of the lengths of the moments. */
SpectrumFile readNdbcSpectra(const std::string& path);

/** True where a text begins as NDBC's does. */
bool looksLikeNdbc(const std::string& firstLine);

}
