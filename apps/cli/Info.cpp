#include "Commands.h"
#include "OptionGroups.h"
#include "OptionKinds.h"

#include "BedTrend.h"
#include "Pipeline.h"

#include "bathymetry/SeafloorReport.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <vtkImageData.h>

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

nlohmann::ordered_json toJson(const SeafloorReport& report, const std::optional<BedTrend>& trend)
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
  const std::optional<BedTrend> trend = bedTrendOf(reader->GetOutput(), report.waterLevel);
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
