#include "Commands.h"
#include "OptionGroups.h"
#include "OptionKinds.h"

#include "Pipeline.h"

#include "bathymetry/SeafloorReport.h"
#include "sim/Angles.h"
#include "sim/SplineSeafloor.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cstdio>
#include <optional>

namespace swellray::cli
{

namespace
{

nlohmann::ordered_json pair(const glm::dvec2& v)
{
  return nlohmann::ordered_json::array({ v.x, v.y });
}

nlohmann::ordered_json box(const Rectangle& r)
{
  return nlohmann::ordered_json::array({ r.low.x, r.low.y, r.high.x, r.high.y });
}

/** How the bed as a whole slopes: the plane that tracing takes for the contours between offshore and the scene. */
struct Trend
{
  double facing = 0.0; ///< nautical degrees of the seaward normal of its contours
  double slope = 0.0;  ///< m/m
};

std::optional<Trend> trendOf(vtkImageData* image, double waterLevel)
{
  ElevationGrid grid;
  grid.columns = static_cast<std::size_t>(image->GetDimensions()[0]);
  grid.rows = static_cast<std::size_t>(image->GetDimensions()[1]);
  grid.origin = { image->GetOrigin()[0], image->GetOrigin()[1] };
  grid.spacing = { image->GetSpacing()[0], image->GetSpacing()[1] };
  vtkDataArray* elevation = image->GetPointData()->GetArray("Elevation");
  grid.elevation.resize(grid.columns * grid.rows);
  for (std::size_t i = 0; i < grid.elevation.size(); ++i)
  {
    grid.elevation[i] = elevation->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  const BedPlane plane = fitWetPlane(SplineSeafloor(grid), waterLevel);
  const double slope = glm::length(plane.slope);
  if (!plane.valid || slope == 0.0)
  {
    return {};
  }
  return Trend{ nauticalFromVector(plane.slope), slope };
}

nlohmann::ordered_json toJson(const SeafloorReport& report, const std::optional<Trend>& trend)
{
  const char* kinds[] = { "local", "projected", "geographic" };
  nlohmann::ordered_json json;
  json["path"] = report.path;
  json["driver"] = report.driver;
  json["variable"] = report.variable;
  json["file"] = { { "columns", report.fileColumns }, { "rows", report.fileRows },
    { "read_columns", report.readColumns }, { "read_rows", report.readRows }, { "extent", box(report.fileExtent) },
    { "spacing", pair(report.fileSpacing) } };
  json["coordinates"] = { { "kind", kinds[static_cast<int>(report.kind)] }, { "crs", report.crsName },
    { "crs_source", report.crsSource }, { "scale_error", report.scaleError } };
  json["grid"] = { { "columns", report.columns }, { "rows", report.rows }, { "spacing_m", pair(report.spacing) },
    { "extent_m", box(report.extent) }, { "resampled", report.resampled } };
  json["water_level_m"] = report.waterLevel;
  json["elevation_m"] = { { "lowest", report.lowest }, { "highest", report.highest } };
  if (trend)
  {
    json["trend"] = { { "facing_deg", trend->facing }, { "slope", trend->slope } };
  }
  json["share"] = { { "water", report.waterShare }, { "land", report.landShare }, { "no_data", report.noDataShare } };
  json["no_data"] = { { "read", report.noDataRead }, { "filled", report.filled } };
  json["values"] = { { "units", report.units }, { "units_source", report.unitsSource }, { "sign", report.sign },
    { "sign_source", report.signSource } };
  if (report.soundings)
  {
    const SoundingReport& soundings = *report.soundings;
    json["soundings"] = { { "count", soundings.count }, { "missing", soundings.missing }, { "used", soundings.used },
      { "duplicates", soundings.duplicates }, { "outliers", soundings.outliers }, { "cells", soundings.cells },
      { "mean_distance_m", soundings.meanDistance }, { "max_gap_m", soundings.maxGap },
      { "left_out", { { "rms_m", soundings.single.rms }, { "largest_m", soundings.single.largest } } } };
  }
  json["notes"] = report.notes;
  return json;
}

void runInfo(const Request& request, Console& console)
{
  Pipeline pipeline(request, console);
  vtkSwellSeafloorReader* reader = pipeline.readSeafloor(Pipeline::Notes::Keep);
  const SeafloorReport& report = *reader->GetReport();
  const std::optional<Trend> trend = trendOf(reader->GetOutput(), report.waterLevel);
  if (request.json)
  {
    const auto text = toJson(report, trend).dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
    std::printf("%s\n", text.c_str());
    return;
  }
  auto lines = report.lines();
  if (trend)
  {
    lines.emplace_back(
      "Bed faces", fmt::format("{:.0f} degrees, slope {:.2g}, as a whole", trend->facing, trend->slope));
  }
  std::size_t width = 0;
  for (const auto& line : lines)
  {
    width = std::max(width, line.first.size());
  }
  for (const auto& [label, text] : lines)
  {
    std::printf("%s\n", fmt::format("{:<{}}  {}", label, width, text).c_str());
  }
}

}

CommandSpec infoSpec(Request& request)
{
  CommandSpec spec{ "info", "tell what a seafloor file holds and how it is understood", true, {}, {} };
  spec.options = { flag("--json", "print as JSON", "Output", request.json) };
  add(spec.options, seafloorOptions(request.seafloor.options));
  spec.examples = "  swellray info harbour.tif\n"
                  "  swellray info soundings.nc --positive down --json\n"
                  "  swellray info babbage\n";
  spec.run = runInfo;
  return spec;
}

}
