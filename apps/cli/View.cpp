#include "BedTrend.h"
#include "Commands.h"
#include "Failure.h"
#include "FieldValues.h"
#include "OptionGroups.h"
#include "OptionKinds.h"
#include "Pipeline.h"

#include "apps/drawing/VirtualDisplay.h"
#include "apps/view/ViewWindow.h"
#include "bathymetry/SeafloorReport.h"

#include <vtkImageData.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace swellray::cli
{

namespace
{

namespace fs = std::filesystem;

std::string titleOf(const std::string& source)
{
  std::error_code none;
  return fs::exists(source, none) ? fs::path(source).stem().string() : source;
}

// Of a built-in form only its name; what may not be in the name of a file is left out.
std::string fileNameOf(const std::string& source)
{
  const std::string title = titleOf(source);
  std::string name = title.substr(0, title.find(':'));
  name.erase(std::remove_if(name.begin(), name.end(),
               [](unsigned char c) { return !std::isalnum(c) && c != '-' && c != '_' && c < 128; }),
    name.end());
  return name.empty() ? "swellray" : name;
}

void checkView(Request& request)
{
  checkRays(request.rays);
  checkPlane(request, "view");
  if (request.view.partial && !request.rays.wanted)
  {
    throw UsageError("--direction and --height need --period; give all three, or none for waves that fit the scene");
  }
}

view::WaveControls controlsOf(const Request& request, vtkImageData* seafloor)
{
  const double level = request.seafloor.options.waterLevel;
  if (request.rays.wanted)
  {
    const IncidentWave& wave = request.rays.wave;
    return { wave.period, wave.directionFrom < 0.0 ? wave.directionFrom + 360.0 : wave.directionFrom, wave.height,
      level };
  }
  double bounds[6];
  seafloor->GetBounds(bounds);
  const auto trend = bedTrendOf(seafloor, level);
  return view::controlsForScene(
    std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]), trend ? trend->facing : 270.0, level);
}

void runView(const Request& request, Console& console)
{
  if (!drawing::VirtualDisplay::answers())
  {
    throw WorkError("view needs a display to open its window on, and none answers: set DISPLAY, or make a picture with "
                    "'swellray render'");
  }
  Pipeline pipeline(request, console);
  vtkSwellSeafloorReader* reader = pipeline.readSeafloor();
  vtkImageData* seafloor = reader->GetOutput();
  const double level = request.seafloor.options.waterLevel;

  view::ViewSetup setup;
  setup.model.seafloor = seafloor;
  setup.model.tracer = [&](vtkSwellRayTracer* tracer) { setUp(tracer, request.rays, level); };
  setup.model.heights = [&](vtkSwellWaveHeight* heights) { setUp(heights, request.rays.height); };
  setup.model.surface = [&](vtkSwellSurface* surface, vtkSwellFoam* foam)
  {
    setUp(surface, request.surface);
    setUp(foam, request.surface);
  };
  setup.controls = controlsOf(request, seafloor);
  setup.ranges = view::rangesAround(setup.controls, level - reader->GetReport()->lowest);
  setup.georeference = georeferenceOf(seafloor);
  setup.title = titleOf(request.seafloor.source);
  setup.size = request.view.size;
  setup.name = fileNameOf(request.seafloor.source);
  view::ViewWindow(setup).run();
}

}

CommandSpec viewSpec(Request& request)
{
  CommandSpec spec{ "view", "a window on the seafloor, its rays and the moving sea, with sliders for the wave", true,
    {}, {} };
  ViewRequest& view = request.view;
  OptionSpec size{ "--size", "WxH", "size of the window, pixels", "1280x800", "Window", false, {} };
  size.set = [&view](const std::string& typed) { view.size = parseSize("--size", typed); };
  spec.options = { size };
  for (OptionSpec& option : waveOptions(request.rays, false))
  {
    // The compass turns plane waves.
    if (option.name == "--from-storm" || option.name == "--from-point")
    {
      continue;
    }
    if (option.name == "--direction" || option.name == "--height")
    {
      const auto set = option.set;
      option.set = [set, &view](const std::string& typed)
      {
        set(typed);
        view.partial = true;
      };
    }
    if (option.name == "--direction")
    {
      option.help = "where the waves come from, degrees clockwise from north";
    }
    if (option.name == "--period" || option.name == "--direction" || option.name == "--height")
    {
      option.standard = "what fits the scene";
    }
    spec.options.push_back(option);
  }
  add(spec.options, rayOptions(request.rays));
  add(spec.options, seafloorOptions(request.seafloor.options));
  spec.examples = "  swellray view bay\n"
                  "  swellray view harbour.tif --period 14 --direction 135 --height 2\n"
                  "Press h in the window for its keys. Pictures (s) and movies (m) are put in the current folder.\n";
  spec.check = checkView;
  spec.run = runView;
  return spec;
}

}
