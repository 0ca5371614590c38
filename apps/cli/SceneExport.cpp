#include "SceneExport.h"

#include "Failure.h"

#include "apps/scene/GltfScene.h"
#include "apps/scene/ScenePage.h"

#include <fmt/format.h>

#include <vtkPolyData.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace swellray::cli
{

namespace
{

namespace fs = std::filesystem;

// A wave looks smooth when as many frames are drawn and moved evenly in between.
constexpr int FramesPerPeriod = 24;

constexpr double CoarsePointsPerWave = 16.0;

// Each particle is a point: fewer than the fine plumes of pictures have.
constexpr double PointSprayRate = 100.0;

std::string textOf(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in || text.str().empty())
  {
    throw WorkError(fmt::format("cannot read '{}', the library of pages", path));
  }
  return text.str();
}

TimeSeries framesOf(const Request& request)
{
  const RenderRequest& render = request.render;
  if (render.times)
  {
    return *render.times;
  }
  if (render.time)
  {
    return { *render.time, *render.time, 1.0 };
  }
  const double step = request.rays.wave.period / FramesPerPeriod;
  return { 0.0, (FramesPerPeriod - 1) * step, step };
}

// The sea of a single time, or of those asked for, no finer than can be given on.
template <typename Scene>
std::size_t addFrames(Scene& scene, const TimeSeries& frames, const Request& request, Pipeline& pipeline,
  Console& console, const char* what)
{
  const std::size_t count = frames.count();
  const auto points = [&](vtkPolyData* surface)
  { return static_cast<std::size_t>(surface->GetNumberOfPoints()) * count; };
  vtkPolyData* surface = pipeline.makeSurface(frames.first);
  if (points(surface) > scene::ScenePage::MostPoints)
  {
    pipeline.setPointsPerWave(CoarsePointsPerWave);
    surface = pipeline.makeSurface(frames.first);
  }
  if (points(surface) > scene::ScenePage::MostPoints)
  {
    throw WorkError(fmt::format("the sea has {} points in each of {} frames, too many for {}; take a part of the "
                                "seafloor with --crop, or fewer frames with --times T0:T1:DT",
      surface->GetNumberOfPoints(), count, what));
  }
  const auto shown = static_cast<std::size_t>(surface->GetNumberOfPoints());
  const double sprayRate = request.surface.sprayRate.value_or(PointSprayRate);
  pipeline.setSpray(sprayRate);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double time = frames.at(i);
    scene.add(pipeline.makeSurface(time), time, sprayRate > 0.0 ? pipeline.makeSpray(time) : nullptr);
    console.progress("frames", static_cast<double>(i + 1) / static_cast<double>(count));
  }
  console.endProgress();
  return shown;
}

void writePage(const Request& request, Pipeline& pipeline, const scene::SceneContent& content, const std::string& title,
  Console& console, OutputFile& file)
{
  const std::string library = textOf(findPageLibrary());
  const TimeSeries frames = framesOf(request);
  scene::PageDetails details;
  details.title = title;
  details.period = request.rays.wave.period;
  details.camera = request.render.camera.value_or(scene::CameraName::Aerial);
  details.ownCamera = request.render.cameraPlace.has_value();
  details.commandLine = request.commandLine;
  scene::ScenePage page(content, details);
  page.setRays(pipeline.computeHeights());
  const std::size_t points = addFrames(page, frames, request, pipeline, console, "a page");
  page.write(file.temporary(), library);
  file.commit();
  console.say(
    fmt::format("wrote {}, {} frames of {} points; open it in a browser", file.path(), frames.count(), points));
}

}

bool isPage(const std::string& file)
{
  return fs::path(file).extension() == ".html";
}

std::string findPageLibrary()
{
  if (const char* own = std::getenv("SWELLRAY_VTKJS"); own && *own)
  {
    return own;
  }
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  const fs::path beside = program.parent_path().parent_path() / "share" / "swellray" / "vtk.js";
  if (!fs::exists(beside, none))
  {
    throw WorkError("pages need vtk.js, which was not there when swellray was built; 'npm pack vtk.js' brings it: "
                    "give the path of vtk.js from its package as SWELLRAY_VTKJS");
  }
  return beside.string();
}

void exportScene(const Request& request, Pipeline& pipeline, const scene::SceneContent& content,
  const std::string& title, Console& console, OutputFile& file)
{
  try
  {
    if (isPage(file.path()))
    {
      writePage(request, pipeline, content, title, console, file);
      return;
    }
    scene::GltfScene scene(content, title, request.rays.wave.period, request.commandLine);
    scene.setRays(pipeline.computeHeights());
    const double time = request.render.time.value_or(0.0);
    addFrames(
      scene, request.render.times.value_or(TimeSeries{ time, time, 1.0 }), request, pipeline, console, "a file");
    scene.write(file.temporary());
  }
  catch (const WorkError&)
  {
    throw;
  }
  catch (const std::runtime_error& error)
  {
    file.fail(error.what());
  }
  file.commit();
  console.say(fmt::format("wrote {}", file.path()));
}

}
