#include "Commands.h"

#include "Pipeline.h"

#include "bathymetry/SeafloorReport.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

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

nlohmann::ordered_json toJson(const SeafloorReport& report)
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
  json["share"] = { { "water", report.waterShare }, { "land", report.landShare }, { "no_data", report.noDataShare } };
  json["no_data"] = { { "read", report.noDataRead }, { "filled", report.filled } };
  json["values"] = { { "units", report.units }, { "units_source", report.unitsSource }, { "sign", report.sign },
    { "sign_source", report.signSource } };
  json["notes"] = report.notes;
  return json;
}

}

void runInfo(const Request& request, Console& console)
{
  Pipeline pipeline(request, console);
  const SeafloorReport& report = *pipeline.readSeafloor()->GetReport();
  if (request.json)
  {
    const auto text = toJson(report).dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
    std::printf("%s\n", text.c_str());
    return;
  }
  const auto lines = report.lines();
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
