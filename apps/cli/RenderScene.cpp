#include "RenderScene.h"

#include "Failure.h"
#include "FieldValues.h"
#include "FrameSheet.h"
#include "OutputFile.h"
#include "PictureSeries.h"
#include "SceneExport.h"

#include "apps/drawing/Scale.h"
#include "apps/drawing/VirtualDisplay.h"
#include "apps/scene/ScenePicture.h"
#include "sim/Angles.h"

#include <fmt/format.h>

#include <vtkImageData.h>
#include <vtkOggTheoraWriter.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

namespace swellray::cli
{

namespace
{

namespace fs = std::filesystem;

constexpr std::array<int, 2> StandardSize{ 1600, 900 };

// The sun stands to the right of one who looks towards the waves, so that it shines through crests.
constexpr double SunRight = 55.0;
constexpr double SunElevation = 32.0;

// The sheet of waves has some more points than the rays; this many take some gigabytes.
constexpr vtkIdType MostRayPoints = 4000000;

// Samples of the water where the camera takes them, pixels apart.
constexpr int PixelsPerSample = 2;

constexpr int FastestMovie = 60; // frames a second

// Particles a metre of crest and metre by which its water is ahead of a wave of 1 m. Droplets are drawn in proportion to the
// waves, and what they cover is to be the same: particles over a metre of crest go as the -1/2 power of the height, so by
// their life and speed the rate as the -3/2.
constexpr double PlumeRate = 1500.0;

// Standard deviation of the components of their velocity, of that of the water: plumes rise by a third of the wave.
constexpr double PlumeScatter = 0.35;

// Particles in the air that are drawn at most, on an average over a period, which is counted at so many times by this rate.
constexpr double MostSpray = 150000.0;
constexpr int CountedTimes = 8;
constexpr double CountedRate = 10.0;

}

scene::SceneCamera cameraOf(const Request& request, vtkImageData* seafloor)
{
  const RenderRequest& render = request.render;
  if (render.cameraPlace)
  {
    const Georeference georeference = georeferenceOf(seafloor);
    const auto& p = *render.cameraPlace;
    const glm::dvec2 eye = georeference.fromFile({ p[0], p[1] });
    const glm::dvec2 focus = georeference.fromFile({ p[3], p[4] });
    scene::SceneCamera camera;
    camera.eye = { eye.x, eye.y, p[2] };
    camera.focus = { focus.x, focus.y, p[5] };
    // Straight down, up is north.
    if (eye == focus)
    {
      camera.up = { 0.0, 1.0, 0.0 };
    }
    return camera;
  }
  return scene::cameraByName(render.camera.value_or(scene::CameraName::Shore),
    { seafloor, request.seafloor.options.waterLevel, request.rays.wave.directionFrom, request.rays.wave.height });
}

namespace
{

class Movie
{
public:
  Movie(const OutputFile& file, double step)
    : File(file)
  {
    this->Writer->SetFileName(file.temporary().c_str());
    this->Writer->SetRate(std::clamp(static_cast<int>(std::lround(1.0 / step)), 1, FastestMovie));
    this->Writer->SetQuality(2);
  }

  void add(vtkImageData* picture)
  {
    this->Writer->SetInputData(picture);
    if (!this->Begun)
    {
      this->Writer->Start();
      this->Begun = true;
    }
    this->Writer->Write();
    if (this->Writer->GetError() != 0)
    {
      this->File.fail("the movie could not be stored");
    }
  }

  void end()
  {
    this->Writer->End();
    if (this->Writer->GetError() != 0)
    {
      this->File.fail("the movie could not be stored");
    }
  }

private:
  const OutputFile& File;
  vtkNew<vtkOggTheoraWriter> Writer;
  bool Begun = false;
};

// The rate of spray asked for, or one that shows a plume over crests that plunge.
double sprayRateOf(const Request& request, Pipeline& pipeline)
{
  if (request.surface.sprayRate)
  {
    return *request.surface.sprayRate;
  }
  double particles = 0.0;
  pipeline.setSpray(CountedRate, PlumeScatter);
  for (int i = 0; i < CountedTimes; ++i)
  {
    particles +=
      static_cast<double>(pipeline.makeSpray(request.rays.wave.period * i / CountedTimes)->GetNumberOfPoints());
  }
  const double most = MostSpray * CountedRate * CountedTimes / std::max(1.0, particles);
  return std::min(PlumeRate * std::pow(request.rays.wave.height, -1.5), most);
}

scene::SceneContent contentOf(const Request& request, Pipeline& pipeline)
{
  const RenderRequest& render = request.render;
  const auto size = render.size.value_or(StandardSize);
  vtkImageData* seafloor = pipeline.readSeafloor(Pipeline::Notes::Keep)->GetOutput();
  scene::SceneContent content;
  content.seafloor = seafloor;
  content.waterLevel = request.seafloor.options.waterLevel;
  content.waveHeight = request.rays.wave.height;
  content.wavelength = 2.0 * Pi / request.rays.wave.wavenumber();
  content.period = request.rays.wave.period;
  content.directionFrom = request.rays.wave.directionFrom;
  content.camera = cameraOf(request, seafloor);
  content.sky = render.sun ? scene::SkyModel((*render.sun)[0], (*render.sun)[1])
                           : scene::SkyModel(std::remainder(content.directionFrom + SunRight, 360.0), SunElevation);
  content.width = size[0];
  content.height = size[1];
  if (render.sheet > 0)
  {
    const auto frame = FrameSheet::frameSize(size, render.times->count(), static_cast<std::size_t>(render.sheet));
    content.width = frame[0];
    content.height = frame[1];
  }
  return content;
}

// Draws the water by its sheets, or as the camera of the scene sees it.
class SceneFrames
{
public:
  SceneFrames(Pipeline& pipeline, const scene::SceneContent& content, bool bySheets, double sprayRate)
    : Source(pipeline)
    , BySheets(bySheets)
    , Picture(content)
  {
    pipeline.seeBy(content.camera, { content.width, content.height }, PixelsPerSample);
    pipeline.setSpray(sprayRate, PlumeScatter);
  }

  vtkSmartPointer<vtkImageData> draw(double time)
  {
    vtkPolyData* surface = this->BySheets ? this->Source.makeSurface(time) : this->Source.makeSeenSurface(time);
    return this->Picture.draw(surface, time, this->Source.makeSpray(time));
  }

private:
  Pipeline& Source;
  const bool BySheets;
  const drawing::VirtualDisplay Display;
  scene::ScenePicture Picture;
};

// Pictures of the very same call that are there are kept.
void drawSeries(
  const Request& request, Pipeline& pipeline, const scene::SceneContent& content, bool bySheets, Console& console)
{
  const std::string& name = request.output.file;
  const fs::path folder = fs::path(name).parent_path();
  std::error_code error;
  if (!folder.empty() && !fs::create_directories(folder, error) && error)
  {
    throw WorkError(fmt::format("cannot make the folder '{}': {}", folder.string(), error.message()));
  }
  SceneFrames frames(pipeline, content, bySheets, sprayRateOf(request, pipeline));
  const TimeSeries& times = *request.render.times;
  const std::size_t count = times.count();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const PictureOrigin origin{ request.commandLine, times.at(i) };
    const std::string path = numberedName(name, i);
    if (isPictureOf(path, origin))
    {
      ++kept;
    }
    else
    {
      OutputFile file(path, inputFiles(request));
      writePicture(frames.draw(origin.time), origin, file);
      file.commit();
    }
    console.progress("frames", static_cast<double>(i + 1) / static_cast<double>(count));
  }
  console.endProgress();
  console.say(fmt::format("wrote {} to {}, {} made and {} kept, {} x {} pixels", numberedName(name, 0),
    numberedName(name, count - 1), count - kept, kept, content.width, content.height));
}

void drawScene(const Request& request, Pipeline& pipeline, const scene::SceneContent& content, bool bySheets,
  Console& console, OutputFile& file)
{
  const RenderRequest& render = request.render;
  SceneFrames frames(pipeline, content, bySheets, sprayRateOf(request, pipeline));
  if (!render.times)
  {
    const double time = render.time.value_or(0.0);
    writePicture(frames.draw(time), { request.commandLine, time }, file);
    file.commit();
    console.say(fmt::format("wrote {}, {} x {} pixels", file.path(), content.width, content.height));
    return;
  }
  const std::size_t count = render.times->count();
  if (render.sheet > 0)
  {
    FrameSheet sheet(count, static_cast<std::size_t>(render.sheet));
    for (std::size_t i = 0; i < count; ++i)
    {
      const double time = render.times->at(i);
      sheet.add(frames.draw(time), fmt::format("{} s", drawing::shortNumber(time)));
      console.progress("frames", static_cast<double>(i + 1) / static_cast<double>(count));
    }
    console.endProgress();
    writePicture(sheet.picture(), { request.commandLine, render.times->first }, file);
    file.commit();
    console.say(
      fmt::format("wrote {}, {} frames of {} x {} pixels", file.path(), count, content.width, content.height));
    return;
  }
  Movie movie(file, render.times->step);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double time = render.times->at(i);
    movie.add(frames.draw(time));
    console.progress("frames", static_cast<double>(i + 1) / static_cast<double>(count));
  }
  console.endProgress();
  movie.end();
  file.commit();
  console.say(fmt::format("wrote {}, {} frames of {} x {} pixels", file.path(), count, content.width, content.height));
}

}

void renderScene(const Request& request, const std::string& title, Console& console)
{
  // Files are opened, and libraries found, before the work that they wait for.
  const std::vector<std::string> inputs = inputFiles(request);
  std::optional<OutputFile> file;
  std::optional<OutputFile> sceneFile;
  const bool series = isNumbered(request.output.file);
  if (!request.output.file.empty() && !series)
  {
    file.emplace(request.output.file, inputs);
  }
  if (!request.output.scene.empty())
  {
    sceneFile.emplace(request.output.scene, inputs);
    if (isPage(request.output.scene))
    {
      findPageLibrary();
    }
  }
  Pipeline pipeline(request, console);
  pipeline.readSeafloor();
  pipeline.traceRays();
  const bool many = pipeline.computeHeights()->GetNumberOfPoints() > MostRayPoints;
  const SceneDetail detail = request.render.detail;
  if (many && (detail == SceneDetail::Waves || !request.output.scene.empty()))
  {
    throw WorkError("the scene has too many waves to be drawn one by one; take a part of the seafloor with --crop");
  }
  const bool bySheets = detail == SceneDetail::Waves || (detail == SceneDetail::Auto && !many);
  const scene::SceneContent content = contentOf(request, pipeline);
  if (file)
  {
    drawScene(request, pipeline, content, bySheets, console, *file);
  }
  if (series)
  {
    drawSeries(request, pipeline, content, bySheets, console);
  }
  if (sceneFile)
  {
    exportScene(request, pipeline, content, title, console, *sceneFile);
  }
}

}
