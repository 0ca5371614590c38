#include "MapOutput.h"

#include "FieldValues.h"
#include "Pipeline.h"
#include "VtkFiles.h"

#include "bathymetry/MapWriter.h"

#include <fmt/format.h>

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>

#include <filesystem>
#include <stdexcept>

namespace swellray::cli
{

namespace
{

struct Quantity
{
  const char* name;
  const char* longName;
  const char* unit;
  const char* standardName; // of the CF table; there is none for the height of one regular wave
  const char* flagMeanings;
};

constexpr Quantity Quantities[] = {
  { "Elevation", "elevation of the bed, positive up", "m", "", "" },
  { "Depth", "depth below the still-water level, negative on land", "m", "sea_floor_depth_below_sea_surface", "" },
  { "WaveHeight", "height of the wave, crest to trough", "m", "", "" },
  { "DirectionFrom", "direction the wave comes from, clockwise from north", "degree", "sea_surface_wave_from_direction",
    "" },
  { "Wavelength", "length of the wave", "m", "", "" },
  { "WavePhase", "phase of the wave; a crest stands where it is that of the time", "radian", "", "" },
  { "Foam", "foam, 1 where a wave breaks now", "1", "", "" },
  { "Breaking", "breaking of the highest wave", "1", "", "not_breaking breaking" },
  { "LeeRay", "rays that model diffraction into the lee bring the highest wave", "1", "", "refraction diffraction" },
  { "RayCount", "number of ray sheets", "1", "", "" },
  { "SignificantWaveHeight", "significant wave height, 4 sqrt(m0)", "m", "sea_surface_wave_significant_height", "" },
  { "PeakPeriod", "peak period", "s", "sea_surface_wave_period_at_variance_spectral_density_maximum", "" },
  { "MeanPeriod", "mean period m0/m1", "s",
    "sea_surface_wave_mean_period_from_variance_spectral_density_first_frequency_moment", "" },
  { "ZeroCrossingPeriod", "mean period sqrt(m0/m2)", "s",
    "sea_surface_wave_mean_period_from_variance_spectral_density_second_frequency_moment", "" },
  { "EnergyPeriod", "energy period m-1/m0", "s",
    "sea_surface_wave_mean_period_from_variance_spectral_density_inverse_frequency_moment", "" },
  { "MeanDirectionFrom", "mean direction the sea comes from, clockwise from north", "degree",
    "sea_surface_wave_from_direction", "" },
  { "DirectionalSpread", "circular standard deviation of the directions", "degree",
    "sea_surface_wave_directional_spread", "" },
};

MapImage imageOf(vtkImageData* map, const Request& request)
{
  MapImage image;
  const int* size = map->GetDimensions();
  image.columns = static_cast<std::size_t>(size[0]);
  image.rows = static_cast<std::size_t>(size[1]);
  image.origin = { map->GetOrigin()[0], map->GetOrigin()[1] };
  image.spacing = { map->GetSpacing()[0], map->GetSpacing()[1] };
  image.place = georeferenceOf(map);
  image.source = "Swellray " SWELLRAY_VERSION;
  image.history = request.commandLine;
  for (const Quantity& quantity : Quantities)
  {
    MapVariable variable;
    variable.name = quantity.name;
    variable.longName = quantity.longName;
    variable.unit = quantity.unit;
    variable.standardName = quantity.standardName;
    variable.flagMeanings = quantity.flagMeanings;
    vtkDataArray* array = map->GetPointData()->GetArray(quantity.name);
    if (!array)
    {
      continue;
    }
    if (auto* numbers = vtkDoubleArray::SafeDownCast(array))
    {
      variable.numbers = numbers->GetPointer(0);
    }
    else if (auto* integers = vtkIntArray::SafeDownCast(array))
    {
      variable.integers = integers->GetPointer(0);
    }
    else if (auto* bytes = vtkUnsignedCharArray::SafeDownCast(array))
    {
      variable.bytes = bytes->GetPointer(0);
    }
    image.variables.push_back(variable);
  }
  return image;
}

}

void writeMap(vtkImageData* map, const OutputFile& file, const Request& request, Console& console)
{
  const std::string ending = std::filesystem::path(file.path()).extension().string();
  if (ending == ".vti")
  {
    vtkNew<vtkXMLImageDataWriter> writer;
    writeXml(writer, map, file, request, console);
    return;
  }
  try
  {
    const MapImage image = imageOf(map, request);
    if (ending == ".nc")
    {
      writeNetcdf(file.temporary(), image);
    }
    else
    {
      writeGeoTiff(file.temporary(), image);
    }
  }
  catch (const std::runtime_error& error)
  {
    file.fail(error.what());
  }
}

}
