#include "Commands.h"

#include "Chart.h"
#include "Failure.h"
#include "FieldValues.h"
#include "Pipeline.h"

#include <fmt/format.h>

#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <cmath>
#include <filesystem>

namespace swellray::cli
{

namespace
{

std::string titleOf(const Request& request)
{
  if (!request.render.title.empty())
  {
    return request.render.title;
  }
  std::error_code none;
  const std::filesystem::path source(request.seafloor.source);
  return std::filesystem::exists(source, none) ? source.stem().string() : request.seafloor.source;
}

// Lines from a file must lie in the same plane as the seafloor.
void checkSamePlace(vtkDataObject* lines, vtkDataObject* seafloor, const std::string& path)
{
  constexpr double SameDegrees = 1e-9;
  constexpr double SameMetres = 1e-3;
  for (const char* name : { "OriginX", "OriginY", "OriginLongitude", "OriginLatitude" })
  {
    const auto here = fieldNumber(seafloor, name);
    const auto there = fieldNumber(lines, name);
    const double same = std::string(name).find("itude") == std::string::npos ? SameMetres : SameDegrees;
    if (here && there && std::abs(*here - *there) > same)
    {
      throw WorkError(
        fmt::format("'{}' was made on another seafloor: its {} is {:.10g}, not {:.10g}; render it with the "
                    "seafloor and the seafloor options it was traced with",
          path, name, *there, *here));
    }
  }
}

}

void runRender(const Request& request, Console& console)
{
  OutputFile file(request.output.file, inputFiles(request));
  Pipeline pipeline(request, console);
  vtkImageData* seafloor = pipeline.readSeafloor()->GetOutput();

  ChartContent content;
  content.seafloor = seafloor;
  content.waterLevel = request.seafloor.options.waterLevel;
  content.title = titleOf(request);
  content.colorBy = request.render.colorBy == "none" ? "" : request.render.colorBy;

  vtkSmartPointer<vtkPolyData> rays;
  if (request.rays.wanted)
  {
    pipeline.traceRays();
    rays = pipeline.computeHeights();
  }
  else if (!request.render.rays.empty())
  {
    rays = readLines(request.render.rays, console);
    checkSamePlace(rays, seafloor, request.render.rays);
    if (content.waterLevel == 0.0)
    {
      content.waterLevel = fieldNumber(rays, "WaterLevel").value_or(0.0);
    }
  }
  content.rays = rays;

  vtkSmartPointer<vtkPolyData> crests;
  if (request.render.crests == CrestsFromRays)
  {
    crests = pipeline.makeCrests(rays);
  }
  else if (!request.render.crests.empty())
  {
    crests = readLines(request.render.crests, console);
    checkSamePlace(crests, seafloor, request.render.crests);
  }
  content.crests = crests;
  content.contours = pipeline.makeContours(content.waterLevel);

  double bounds[6];
  seafloor->GetBounds(bounds);
  const ChartLayout layout = layOutChart(request.render.size, (bounds[3] - bounds[2]) / (bounds[1] - bounds[0]));
  const bool jpeg = std::filesystem::path(request.output.file).extension() == ".jpg";
  if (!drawChart(content, layout, file.temporary(), jpeg))
  {
    file.fail("the picture could not be stored");
  }
  file.commit();
  console.say(fmt::format("wrote {}, {} x {} pixels", file.path(), layout.width, layout.height));
}

}
