#include "Commands.h"
#include "OptionGroups.h"
#include "OptionKinds.h"

#include "Chart.h"
#include "Failure.h"
#include "FieldValues.h"
#include "PictureSeries.h"
#include "Pipeline.h"
#include "RayStarts.h"
#include "RenderScene.h"
#include "RenderSection.h"
#include "SceneExport.h"
#include "SurfaceOptions.h"
#include "TimeSeriesOption.h"
#include "VtkFiles.h"

#include "bathymetry/ObstacleReader.h"

#include <fmt/format.h>

#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

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

// From their file, or from the rays that met them.
std::vector<Obstacle> obstaclesToDraw(const Request& request, vtkImageData* seafloor, vtkPolyData* rays)
{
  if (request.rays.obstacles.empty() || request.rays.wanted)
  {
    return rays ? obstaclesOf(rays) : std::vector<Obstacle>();
  }
  double bounds[6];
  seafloor->GetBounds(bounds);
  try
  {
    return readObstacles(request.rays.obstacles, georeferenceOf(seafloor),
      { { bounds[0], bounds[2] }, { bounds[1], bounds[3] } }, request.rays.reflection.value_or(0.0))
      .obstacles;
  }
  catch (const std::runtime_error& error)
  {
    throw WorkError(error.what());
  }
}

// Options that a picture of this style cannot follow.
void checkStyle(const Request& request)
{
  const RenderRequest& render = request.render;
  const bool movie = std::filesystem::path(request.output.file).extension() == ".ogv";
  if (render.style != PictureStyle::Scene &&
    (render.sceneOnly || request.surface.sprayRate || movie || isNumbered(request.output.file)))
  {
    throw UsageError("--camera, --sun, --detail, --sheet, --spray-rate, a movie (.ogv) and numbered pictures need "
                     "--style scene");
  }
  if (render.style != PictureStyle::Section && (render.line || render.exaggeration))
  {
    throw UsageError("--line and --exaggeration need --style section");
  }
  if (render.style == PictureStyle::Chart && (render.seaOnly || render.time || render.times))
  {
    throw UsageError(
      "--time, --times, --profile, --component, --group-waves, --group-lull, --foam-life and --seed need "
      "--style scene or --style section");
  }
}

// A picture of the sea, not of rays.
void checkSea(const Request& request)
{
  const RenderRequest& render = request.render;
  const std::string style = render.style == PictureStyle::Scene ? "--style scene" : "--style section";
  checkPlane(request, style.c_str());
  if (!request.rays.wanted)
  {
    throw UsageError(style + " needs waves: give --period, --direction and --height");
  }
  if (!render.rays.empty() || !render.crests.empty() || !render.map.empty())
  {
    throw UsageError(style + " traces its own rays; leave out --rays, --crests and --map");
  }
  if (render.time && render.times)
  {
    throw UsageError("--time and --times exclude each other; leave out one of the two");
  }
  checkSurfaceOptions(request.surface);
}

void checkScene(const Request& request)
{
  const RenderRequest& render = request.render;
  const bool movie = std::filesystem::path(request.output.file).extension() == ".ogv";
  const bool numbered = isNumbered(request.output.file);
  if ((movie || numbered) && !render.times)
  {
    throw UsageError(fmt::format("{} needs --times T0:T1:DT", movie ? "a movie" : "a series of pictures"));
  }
  if (render.sheet > 0 && (!render.times || request.output.file.empty() || movie || numbered))
  {
    throw UsageError("--sheet puts the frames of --times T0:T1:DT into one picture: give -o FILE.png or -o FILE.jpg");
  }
  if (render.times && !movie && !numbered && render.sheet == 0 && request.output.scene.empty())
  {
    throw UsageError("--times needs a movie, numbered pictures, a sheet of frames or a scene to write: -o FILE.ogv, -o "
                     "FOLDER/%04d.png, --sheet N -o FILE.png, --export FILE.html or --export FILE.gltf");
  }
  if (numbered && std::filesystem::path(request.output.file).extension() != ".png")
  {
    throw UsageError("a series of pictures is .png");
  }
  if (render.profiles.size() > 1)
  {
    throw UsageError("a scene has one --profile; --style section shows several");
  }
}

// What VTK can write here; of other kinds of movies how they are made of it.
OptionSpec pictureOption(std::string& target)
{
  OptionSpec spec =
    outputFile("-o,--output", "picture, .png or .jpg; of a scene also a movie, .ogv, or numbered pictures, %04d.png",
      target, { ".png", ".jpg", ".ogv" });
  const auto setName = spec.set;
  spec.set = [setName](const std::string& typed)
  {
    const std::string ending = std::filesystem::path(typed).extension().string();
    if (ending == ".mp4" || ending == ".avi" || ending == ".webm" || ending == ".mov")
    {
      throw UsageError(fmt::format("VTK writes no {} here: write -o FILE.ogv, or -o FOLDER/%04d.png and make it with "
                                   "'ffmpeg -framerate 25 -i FOLDER/%04d.png FILE{}'",
        ending, ending));
    }
    setName(typed);
  };
  return spec;
}

}

OptionSpec cameraOption(RenderRequest& render)
{
  OptionSpec spec{ "--camera", "shore|aerial|chart|X,Y,Z,FX,FY,FZ",
    "where a scene is seen from: on the beach, from the air, from above, or eye and what it looks at, in the grid's "
    "coordinates and metres of height",
    "shore", "Scene", false, {} };
  spec.set = [&render](const std::string& typed)
  {
    render.sceneOnly = true;
    if (typed.find(',') == std::string::npos)
    {
      const std::vector<std::string> names{ "shore", "aerial", "chart" };
      render.camera = static_cast<scene::CameraName>(parseChoice("--camera", typed, names));
      return;
    }
    const auto values = parseNumbers("--camera", typed, PlainNumber);
    if (values.size() != 6 || (values[0] == values[3] && values[1] == values[4] && values[2] == values[5]))
    {
      throw UsageError(
        fmt::format("--camera needs shore, aerial, chart or X,Y,Z,FX,FY,FZ of two places, not '{}'", typed));
    }
    render.cameraPlace.emplace();
    std::copy(values.begin(), values.end(), render.cameraPlace->begin());
  };
  return spec;
}

namespace
{

OptionSpec sunOption(RenderRequest& render)
{
  OptionSpec spec{ "--sun", "AZIMUTH,ELEVATION",
    "of the sun, degrees clockwise from north and over the horizon, 2 to 90", "55 degrees right of the waves, 32 high",
    "Scene", false, {} };
  spec.set = [&render](const std::string& typed)
  {
    render.sceneOnly = true;
    const auto values = parseNumbers("--sun", typed, Degrees);
    if (values.size() != 2 || values[1] < 2.0 || values[1] > 90.0)
    {
      throw UsageError(
        fmt::format("--sun needs AZIMUTH,ELEVATION with an elevation of 2 to 90 degrees, not '{}'", typed));
    }
    render.sun = { values[0], values[1] };
  };
  return spec;
}

void checkRender(Request& request)
{
  if (request.output.file.empty() && request.output.scene.empty())
  {
    throw UsageError("render has nothing to write: give -o FILE or --export FILE");
  }
  if (!request.output.scene.empty())
  {
    request.render.style = PictureStyle::Scene;
  }
  checkRays(request.rays);
  checkEarth(request);
  checkStart(request);
  checkContours(request.contour);
  const RenderRequest& render = request.render;
  checkStyle(request);
  if (render.style != PictureStyle::Chart)
  {
    checkSea(request);
  }
  if (render.style == PictureStyle::Scene)
  {
    checkScene(request);
  }
  if (request.rays.wanted && !render.rays.empty())
  {
    throw UsageError("--rays draws rays from a file, --period traces new ones; leave out one of the two");
  }
  if (!render.mapBy.empty() && render.map.empty())
  {
    throw UsageError("--map-by needs --map FILE");
  }
  if (!request.rays.wanted && render.rays.empty() && render.crests == CrestsFromRays)
  {
    throw UsageError("--crests auto needs rays: give --rays FILE, or --period, --direction and --height");
  }
}

void runRender(const Request& request, Console& console)
{
  if (request.render.style != PictureStyle::Chart)
  {
    const auto renderSea = request.render.style == PictureStyle::Scene ? renderScene : renderSection;
    renderSea(request, titleOf(request), console);
    return;
  }
  OutputFile file(request.output.file, inputFiles(request));
  Pipeline pipeline(request, console);
  vtkImageData* seafloor = pipeline.readSeafloor()->GetOutput();

  ChartContent content;
  content.seafloor = seafloor;
  content.waterLevel = request.seafloor.options.waterLevel;
  content.title = titleOf(request);
  content.colors = drawing::quantityMaps()[request.render.colorMap].second;
  content.frame = request.render.frame;

  vtkSmartPointer<vtkImageData> map;
  if (!request.render.map.empty())
  {
    map = readImage(request.render.map, console);
    checkSamePlace(map, seafloor, request.render.map);
    content.map = map;
    content.mapBy = request.render.mapBy;
    if (content.mapBy.empty())
    {
      content.mapBy = map->GetPointData()->HasArray("SignificantWaveHeight") ? "SignificantWaveHeight" : "WaveHeight";
    }
  }
  content.colorBy = request.render.colorBy.empty() && !map ? "WaveHeight" : request.render.colorBy;
  if (content.colorBy == "none")
  {
    content.colorBy.clear();
  }

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
  content.obstacles = obstaclesToDraw(request, seafloor, rays);

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
  writePicture(drawChart(content, layout), { request.commandLine, 0.0 }, file);
  file.commit();
  console.say(fmt::format("wrote {}, {} x {} pixels", file.path(), layout.width, layout.height));
}

OptionSpec sheetOption(RenderRequest& render)
{
  OptionSpec spec{ "--sheet", "N", "the frames of --times in one picture of this --size, N a row", "one picture each",
    "Scene", false, {} };
  spec.set = [&render](const std::string& typed)
  {
    render.sceneOnly = true;
    render.sheet = static_cast<int>(parseWhole("--sheet", typed, 1, 100));
  };
  return spec;
}

OptionSpec lineOption(RenderRequest& render)
{
  OptionSpec spec{ "--line", "X0,Y0,X1,Y1", "of a section: from and to, in the grid's coordinates",
    "the way of the waves through the middle", "Section", false, {} };
  spec.set = [&render](const std::string& typed)
  {
    const auto values = parseNumbers("--line", typed, PlainNumber);
    if (values.size() != 4 || (values[0] == values[2] && values[1] == values[3]))
    {
      throw UsageError(fmt::format("--line needs X0,Y0,X1,Y1 of two places, not '{}'", typed));
    }
    render.line = { values[0], values[1], values[2], values[3] };
  };
  return spec;
}

OptionSpec profilesOption(Request& request)
{
  OptionSpec spec = profileOption(request.surface);
  spec.help += "; a section of each that is given";
  spec.repeatable = true;
  spec.set = [set = spec.set, &request](const std::string& typed)
  {
    set(typed);
    request.render.profiles.push_back(typed);
  };
  return spec;
}

OptionSpec detailOption(RenderRequest& render)
{
  OptionSpec spec =
    choice("--detail", "how finely the water is drawn: by the sheets between rays, or where pixels see it",
      "waves; screen where there are too many", "Scene", render.detail,
      std::vector<std::pair<std::string, SceneDetail>>{
        { "auto", SceneDetail::Auto }, { "waves", SceneDetail::Waves }, { "screen", SceneDetail::Screen } });
  const auto setDetail = spec.set;
  spec.set = [setDetail, &render](const std::string& typed)
  {
    render.sceneOnly = true;
    setDetail(typed);
  };
  return spec;
}

}

CommandSpec renderSpec(Request& request)
{
  CommandSpec spec{ "render",
    "draw the seafloor with its waves as a picture: a chart, the water itself, or sections through it", true, {}, {} };
  RenderRequest& render = request.render;
  OptionSpec size{ "--size", "WxH", "size of the picture, pixels", "1600 wide, high as the scene asks", "Picture",
    false, {} };
  size.set = [&render](const std::string& typed) { render.size = parseSize("--size", typed); };
  std::vector<std::pair<std::string, std::size_t>> colorMaps;
  for (const auto& map : drawing::quantityMaps())
  {
    colorMaps.emplace_back(map.first, colorMaps.size());
  }
  spec.options = { pictureOption(request.output.file),
    outputFile("--export", "the scene for others to draw, .gltf; or a page that plays its waves, .html",
      request.output.scene, { ".gltf", ".html" }),
    size,
    choice("--style", "a chart, the water in three dimensions, or cut along a line", "chart", "Picture", render.style,
      std::vector<std::pair<std::string, PictureStyle>>{
        { "chart", PictureStyle::Chart }, { "scene", PictureStyle::Scene }, { "section", PictureStyle::Section } }),
    text("--rays", "FILE", "rays that 'swellray trace' wrote, .vtp", "", "Picture", render.rays),
    text("--map", "FILE",
      "map that 'swellray trace' or 'swellray spectrum' wrote, .vti, on the water in place of depths", "", "Picture",
      render.map),
    text("--map-by", "ARRAY", "its array", "the wave height", "Picture", render.mapBy),
    text("--crests", "FILE|auto", "crest lines from a file, or made from the rays", "", "Picture", render.crests),
    text("--color-by", "ARRAY", "colour the rays by this array, or 'none'", "WaveHeight; over a map none", "Picture",
      render.colorBy),
    choice("--color-map",
      "scale of colours of the rays and the map; all are even to the eye and safe for colour-blind ones", "warm",
      "Picture", render.colorMap, colorMaps),
    choice("--frame", "what the frame counts: metres, or longitude and latitude", "auto: as the grid does", "Picture",
      render.frame,
      std::vector<std::pair<std::string, ChartFrame>>{
        { "auto", ChartFrame::Auto }, { "metric", ChartFrame::Metric }, { "graticule", ChartFrame::Graticule } }),
    text("--title", "TEXT", "heading of the picture", "the seafloor's name", "Picture", render.title) };
  add(spec.options,
    { cameraOption(render), sunOption(render), detailOption(render), sheetOption(render),
      number("--spray-rate", "N", "particles a metre of crest and metre by which its water is ahead of the wave",
        "so that plumes are seen", "Scene", request.surface.sprayRate, { "", 0.0, 1e6 }),
      lineOption(render),
      number("--exaggeration", "N", "how many times larger heights of a section are drawn than distances",
        "so that waves are seen", "Section", render.exaggeration, PositiveNumber),
      number("--time", "S", "time of a scene or section, s", "0", "Surface", render.time, { "seconds" }),
      timesOption(render.times, "Surface") });
  std::vector<OptionSpec> surface = surfaceOptions(request.surface);
  surface.insert(surface.begin(), profilesOption(request));
  for (OptionSpec& option : surface)
  {
    option.set = [set = option.set, &render](const std::string& typed)
    {
      render.seaOnly = true;
      set(typed);
    };
  }
  add(spec.options, surface);
  add(spec.options, contourOptions(request.contour));
  add(spec.options, waveOptions(request.rays, false));
  spec.options.push_back(launchOption(request.start));
  add(spec.options, rayOptions(request.rays));
  add(spec.options, seafloorOptions(request.seafloor.options));
  spec.examples =
    "  swellray render harbour.tif --rays rays.vtp --crests crests.vtp -o picture.png\n"
    "  swellray render harbour.tif --period 14 --direction 135 --height 2 -o picture.png\n"
    "  swellray render harbour.tif --map heights.vti --map-by WaveHeight --rays rays.vtp -o heights.png\n"
    "  swellray render harbour.tif --obstacles breakwater.geojson -o harbour.png\n"
    "  swellray render harbour.tif --interval 5 --size 2400x1800 -o chart.png\n"
    "  swellray render harbour.tif --style scene --period 9 --direction 285 --height 1.5 -o shore.png\n"
    "  swellray render bay --style scene --camera aerial --period 3 --direction 90 --height 0.4 --times "
    "0:10:0.04 -o bay.ogv\n"
    "  swellray render bay --style scene --period 3 --direction 90 --height 0.4 --times 0:2.5:0.5 --sheet "
    "2 -o bay.png\n"
    "  swellray render plane --style section --line 200,0,-20,0 --period 8 --direction 90 --height 1 "
    "--profile airy --profile jeschke -o sections.png\n"
    "  swellray render bay --period 3 --direction 90 --height 0.4 --export bay.html\n"
    "Where no display is set, an X server in memory (Xvfb) is started for the picture.\n";
  spec.check = checkRender;
  spec.run = runRender;
  return spec;
}

}
