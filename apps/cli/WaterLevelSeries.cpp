#include "WaterLevelSeries.h"

#include "Console.h"
#include "Failure.h"
#include "FieldValues.h"
#include "OutputFile.h"
#include "Pipeline.h"
#include "RayValues.h"
#include "StationTable.h"
#include "WaterLevels.h"

#include <fmt/format.h>

#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <fstream>
#include <map>

namespace swellray::cli
{

void traceWaterLevels(const Request& request, Console& console)
{
  OutputFile file(request.output.table, inputFiles(request));
  const StationTable stations(request.map.stations);
  const std::vector<TimedLevel> series = readWaterLevels(request.map.waterLevels);
  std::map<double, std::vector<std::string>> rows; // of each level

  // The seafloor is read once, as it lies at high water.
  Request highest = request;
  highest.seafloor.options.waterLevel = std::max_element(series.begin(), series.end(),
    [](const TimedLevel& a, const TimedLevel& b)
    { return a.level < b.level; })->level;
  for (const TimedLevel& moment : series)
  {
    rows.emplace(moment.level, std::vector<std::string>());
  }
  Pipeline pipeline(highest, console);
  vtkImageData* seafloor = pipeline.readSeafloor()->GetOutput();
  const auto places = stations.places(georeferenceOf(seafloor));
  std::size_t done = 0;
  std::size_t dry = 0;
  for (auto& [level, lines] : rows)
  {
    pipeline.setWaterLevel(level);
    try
    {
      pipeline.traceRays();
    }
    catch (const WorkError& error)
    {
      throw WorkError(fmt::format("at the water level {:g} m: {}", level, error.what()));
    }
    vtkPolyData* rays = pipeline.computeHeights();
    const auto waves = wavesAt(places, rays, seafloor, request, console);
    std::size_t without = 0;
    lines = stations.rows(waves->GetPointData(), stationColumns(), "WaveHeight", without);
    dry += without;
    console.say(
      fmt::format("level    {} of {}: {:g} m, {} rays", ++done, rows.size(), level, rays->GetNumberOfCells()));
  }

  std::ofstream table(file.temporary(), std::ios::trunc);
  table << "Time,WaterLevel," << stations.heading(stationColumns()) << '\n';
  for (const TimedLevel& moment : series)
  {
    for (const std::string& line : rows.at(moment.level))
    {
      table << moment.time << ',' << fmt::format("{:.10g}", moment.level) << ',' << line << '\n';
    }
  }
  table.close();
  if (!table)
  {
    file.fail("the disk is full, or files may not get so large");
  }
  file.commit();
  if (dry > 0)
  {
    console.warn(fmt::format(
      "no wave came to {} of {} points and levels: their fields are empty", dry, rows.size() * stations.size()));
  }
  console.say(fmt::format(
    "wrote    {}: {} times, {} points, {} different levels", file.path(), series.size(), stations.size(), rows.size()));
}

}
