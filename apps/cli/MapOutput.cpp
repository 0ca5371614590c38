#include "MapOutput.h"

#include "FieldValues.h"
#include "FilterRun.h"
#include "Pipeline.h"

#include "bathymetry/MapWriter.h"

#include <fmt/format.h>

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSwellMap.h>
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
  { "Breaking", "breaking of the highest wave", "1", "", "not_breaking breaking" },
  { "LeeRay", "rays that model diffraction into the lee bring the highest wave", "1", "", "refraction diffraction" },
  { "RayCount", "number of ray sheets", "1", "", "" },
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

// Share of the nodes in water that no ray reaches.
void sayCoverage(vtkImageData* map, const Console& console)
{
  vtkDataArray* depth = map->GetPointData()->GetArray("Depth");
  vtkDataArray* count = map->GetPointData()->GetArray("RayCount");
  vtkIdType wet = 0;
  vtkIdType covered = 0;
  vtkIdType crossed = 0;
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    wet += depth->GetComponent(i, 0) > 0.0 ? 1 : 0;
    covered += count->GetComponent(i, 0) > 0.0 ? 1 : 0;
    crossed += count->GetComponent(i, 0) > 1.0 ? 1 : 0;
  }
  const auto share = [=](vtkIdType part)
  { return wet > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(wet) : 0.0; };
  const int* size = map->GetDimensions();
  console.say(
    fmt::format("map      {} x {} nodes {:.4g} m apart; rays reach {:.3g} % of those in water, several {:.3g} %",
      size[0], size[1], map->GetSpacing()[0], share(covered), share(crossed)));
}

}

void writeMap(
  vtkPolyData* rays, vtkImageData* seafloor, const OutputFile& file, const Request& request, Console& console)
{
  vtkNew<vtkSwellMap> filter;
  filter->SetInputData(0, rays);
  filter->SetInputData(1, seafloor);
  filter->SetWaterLevel(request.seafloor.options.waterLevel);
  filter->SetSpacing(request.map.spacing.value_or(0.0));
  filter->SetCombineRule(request.map.combine == CombineRule::Phase ? vtkSwellMap::PHASE : vtkSwellMap::ENERGY);
  runFilter(filter, "map", console);
  vtkImageData* map = filter->GetOutput();
  sayCoverage(map, console);

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
