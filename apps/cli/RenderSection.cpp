#include "RenderSection.h"

#include "Failure.h"
#include "FieldValues.h"
#include "OutputFile.h"
#include "PictureSeries.h"
#include "Pipeline.h"
#include "SectionChart.h"

#include "apps/drawing/Scale.h"
#include "sim/Angles.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace swellray::cli
{

namespace
{

constexpr int BedPlaces = 2000;

// Panels that can still be told apart.
constexpr std::size_t MostPanels = 40;

// Land that is shown beyond the water, of the length of the line.
constexpr double LandShown = 0.05;

// The part of a line from its first to its last water, with some land.
drawing::CutLine wetPart(const drawing::CutLine& line, vtkImageData* seafloor, double waterLevel)
{
  const std::vector<double> bed = drawing::cutSeafloor(seafloor, line, BedPlaces);
  const auto wet = [waterLevel](double elevation) { return elevation < waterLevel; };
  const auto first = std::find_if(bed.begin(), bed.end(), wet);
  const auto last = std::find_if(bed.rbegin(), bed.rend(), wet);
  if (first == bed.end())
  {
    return line;
  }
  const double count = BedPlaces - 1.0;
  const double begin = std::max(0.0, static_cast<double>(first - bed.begin()) / count - LandShown);
  const double end = std::min(1.0, 1.0 - static_cast<double>(last - bed.rbegin()) / count + LandShown);
  return { line.from + begin * (line.to - line.from), line.from + end * (line.to - line.from) };
}

// The line asked for, or the way of the waves through the middle of the scene.
drawing::CutLine lineOf(const Request& request, vtkImageData* seafloor)
{
  if (request.render.line)
  {
    const Georeference georeference = georeferenceOf(seafloor);
    const auto& p = *request.render.line;
    return { georeference.fromFile({ p[0], p[1] }), georeference.fromFile({ p[2], p[3] }) };
  }
  double bounds[6];
  seafloor->GetBounds(bounds);
  const glm::dvec2 middle(0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]));
  const double heading = headingFromNautical(request.rays.wave.directionFrom);
  const glm::dvec2 way(std::cos(heading), std::sin(heading));
  double reach = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 2; ++axis)
  {
    if (std::abs(way[axis]) > 1e-9)
    {
      reach = std::min(reach, 0.5 * (bounds[2 * axis + 1] - bounds[2 * axis]) / std::abs(way[axis]));
    }
  }
  return wetPart({ middle - reach * way, middle + reach * way }, seafloor, request.seafloor.options.waterLevel);
}

}

void renderSection(const Request& request, const std::string& title, Console& console)
{
  const RenderRequest& render = request.render;
  OutputFile file(request.output.file, inputFiles(request));
  Pipeline pipeline(request, console);
  vtkImageData* seafloor = pipeline.readSeafloor()->GetOutput();
  pipeline.traceRays();
  vtkPolyData* rays = pipeline.computeHeights();
  const drawing::CutLine line = lineOf(request, seafloor);

  std::vector<double> times{ render.time.value_or(0.0) };
  if (render.times)
  {
    times.resize(render.times->count());
    for (std::size_t i = 0; i < times.size(); ++i)
    {
      times[i] = render.times->at(i);
    }
  }
  std::vector<std::string> profiles = render.profiles;
  if (profiles.empty())
  {
    profiles.push_back(request.surface.profile);
  }
  if (profiles.size() * times.size() > MostPanels)
  {
    throw UsageError(fmt::format("sections at {} times by {} profiles are more than the {} of one picture; take fewer",
      times.size(), profiles.size(), MostPanels));
  }
  SectionContent content;
  content.length = line.length();
  content.waterLevel = request.seafloor.options.waterLevel;
  content.bed = drawing::cutSeafloor(seafloor, line, BedPlaces);
  content.title = title;
  bool any = false;
  for (const std::string& profile : profiles)
  {
    pipeline.setProfile(profile);
    for (const double time : times)
    {
      SectionPanel panel;
      const std::string when = fmt::format("{} s", drawing::shortNumber(time));
      panel.label = times.size() == 1 ? profile : profiles.size() == 1 ? when : profile + ", " + when;
      panel.water = drawing::cutSurface(pipeline.makeSurface(time), line);
      for (const drawing::CutSegment& segment : panel.water)
      {
        if (segment.begin.x >= 0.0 && segment.begin.x <= content.length)
        {
          any = true;
          content.highest = std::max(content.highest, segment.begin.y - content.waterLevel);
        }
      }
      content.panels.push_back(std::move(panel));
      console.progress(
        "sections", static_cast<double>(content.panels.size()) / static_cast<double>(profiles.size() * times.size()));
    }
  }
  console.endProgress();
  if (!any)
  {
    throw WorkError("no wave comes to the line of the section: choose another --line");
  }
  const SectionLayout layout = layOutSections(content, render.size, render.exaggeration);
  content.caption = waveWords(rays);
  if (times.size() == 1 || profiles.size() == 1)
  {
    content.caption += "  \u00b7  " +
      (times.size() == 1 ? fmt::format("at {} s", drawing::shortNumber(times.front())) : profiles.front());
  }
  content.caption += "  \u00b7  " +
    (layout.exaggeration == 1.0 ? std::string("heights to scale")
                                : fmt::format("heights times {}", drawing::shortNumber(layout.exaggeration)));
  writePicture(drawSections(content, layout), { request.commandLine, times.front() }, file);
  file.commit();
  console.say(fmt::format("wrote {}, {} x {} pixels; heights are drawn {} times as large as distances", file.path(),
    layout.width, layout.height, drawing::shortNumber(layout.exaggeration)));
}

}
