#include "Commands.h"
#include "Failure.h"
#include "FieldValues.h"
#include "FilterRun.h"
#include "OptionGroups.h"
#include "OptionKinds.h"
#include "Pipeline.h"

#include "sim/sections/WaveSection.h"

#include <fmt/format.h>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>

namespace swellray::cli
{

namespace
{

namespace fs = std::filesystem;

constexpr long long MostFrames = 1'000'000;

// Steps of a series; a length that is whole steps but for rounding keeps its last.
long long frameCount(const TimeSeries& times)
{
  constexpr double rounding = 1e-9;
  return static_cast<long long>(std::floor((times.last - times.first) / times.step + rounding)) + 1;
}

OptionSpec timesOption(SurfaceRequest& surface)
{
  OptionSpec spec{ "--times", "T0:T1:DT", "first and last time and step of a series, s", "", "Surface", false, {} };
  spec.set = [&surface](const std::string& typed)
  {
    std::string commas = typed;
    for (char& c : commas)
    {
      c = c == ':' ? ',' : c == ',' ? ':' : c;
    }
    const auto values = parseNumbers("--times", commas, { "seconds" });
    if (values.size() != 3 || !(values[1] >= values[0]) || !(values[2] > 0.0))
    {
      throw UsageError(fmt::format("--times needs T0:T1:DT with T0 <= T1 and DT > 0, not '{}'", typed));
    }
    const TimeSeries times{ values[0], values[1], values[2] };
    if (!((times.last - times.first) / times.step < static_cast<double>(MostFrames)))
    {
      throw UsageError("--times has more than a million frames; take a larger step");
    }
    surface.times = times;
  };
  return spec;
}

OptionSpec profileOption(SurfaceRequest& surface)
{
  std::string names;
  for (const FormDescription& section : waveSections())
  {
    names += (names.empty() ? "" : ", ") + section.name;
  }
  OptionSpec spec = text("--profile", "NAME:key=value,...", ("vertical section of the waves: " + names).c_str(),
    surface.profile.c_str(), "Surface", surface.profile);
  const auto setName = spec.set;
  spec.set = [setName](const std::string& typed)
  {
    setName(typed);
    try
    {
      makeWaveSection(typed);
    }
    catch (const std::invalid_argument& error)
    {
      throw UsageError(fmt::format("--profile: {}", error.what()));
    }
  };
  return spec;
}

bool isSeries(const Request& request)
{
  return fs::path(request.output.file).extension() == ".pvd";
}

void checkSurface(Request& request)
{
  checkRays(request.rays);
  checkPlane(request, "surface");
  const SurfaceRequest& surface = request.surface;
  if (request.output.file.empty())
  {
    throw UsageError("surface has nothing to write: give -o FILE.vtp, or -o FILE.pvd with --times");
  }
  if (surface.time && surface.times)
  {
    throw UsageError("--time and --times exclude each other; leave out one of the two");
  }
  if (isSeries(request) != surface.times.has_value())
  {
    throw UsageError(
      isSeries(request) ? "a .pvd series needs --times T0:T1:DT" : "--times needs a series to write: -o FILE.pvd");
  }
}

void writeVtp(vtkPolyData* surface, const OutputFile& file, const Request& request, Console& console)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writeXml(writer, surface, file, request, console);
}

void saySurface(vtkPolyData* surface, const Console& console)
{
  console.say(fmt::format("surface  {}: {} points, {} triangles", fieldText(surface, "Section"),
    surface->GetNumberOfPoints(), surface->GetPolys()->GetNumberOfCells()));
}

// True where the file is a whole frame of this very call.
bool isKept(const fs::path& frame, double time, const Request& request, Console& console)
{
  std::error_code none;
  if (!fs::exists(frame, none))
  {
    return false;
  }
  try
  {
    const vtkSmartPointer<vtkPolyData> surface = readLines(frame.string(), console);
    return surface->GetNumberOfPoints() > 0 && fieldNumber(surface, "Time") == time &&
      fieldText(surface, "CommandLine") == request.commandLine;
  }
  catch (const WorkError&)
  {
    return false;
  }
}

void writeSeriesFile(const OutputFile& file, const std::vector<std::pair<double, std::string>>& frames)
{
  std::ofstream out(file.temporary(), std::ios::trunc);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n";
  for (const auto& [time, name] : frames)
  {
    out << fmt::format("    <DataSet timestep=\"{}\" file=\"{}\"/>\n", time, name);
  }
  out << "  </Collection>\n</VTKFile>\n";
  out.close();
  if (!out)
  {
    file.fail("it could not be written whole");
  }
}

void writeSeries(Pipeline& pipeline, const OutputFile& file, const Request& request, Console& console)
{
  const TimeSeries& times = *request.surface.times;
  const fs::path series(request.output.file);
  const fs::path folder = series.parent_path() / series.stem();
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
  {
    throw WorkError(fmt::format("cannot make the folder '{}': {}", folder.string(), error.message()));
  }
  const long long count = frameCount(times);
  long long kept = 0;
  std::vector<std::pair<double, std::string>> frames;
  const auto start = std::chrono::steady_clock::now();
  for (long long i = 0; i < count; ++i)
  {
    const double time = times.first + static_cast<double>(i) * times.step;
    const std::string name = fmt::format("{}_{:06}.vtp", series.stem().string(), i);
    frames.emplace_back(time, (series.stem() / name).string());
    if (isKept(folder / name, time, request, console))
    {
      ++kept;
    }
    else
    {
      vtkPolyData* surface = pipeline.makeSurface(time);
      OutputFile frame((folder / name).string(), {});
      writeVtp(surface, frame, request, console);
      frame.commit();
      if (i == kept)
      {
        saySurface(surface, console);
      }
    }
    console.progress("frames", static_cast<double>(i + 1) / static_cast<double>(count));
  }
  console.endProgress();
  writeSeriesFile(file, frames);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  console.say(fmt::format("frames   {}: {} made in {:.2f} s, {} kept", count, count - kept, seconds, kept));
}

void runSurface(const Request& request, Console& console)
{
  OutputFile file(request.output.file, inputFiles(request));
  Pipeline pipeline(request, console);
  pipeline.readSeafloor();
  pipeline.traceRays();
  pipeline.computeHeights();
  if (isSeries(request))
  {
    writeSeries(pipeline, file, request, console);
  }
  else
  {
    vtkPolyData* surface = pipeline.makeSurface(request.surface.time.value_or(0.0));
    saySurface(surface, console);
    writeVtp(surface, file, request, console);
  }
  file.commit();
  console.say(fmt::format("wrote    {}; open with: paraview {}", file.path(), file.path()));
}

}

CommandSpec surfaceSpec(Request& request)
{
  CommandSpec spec{ "surface", "the breaking-wave surface with its foam, at a time or as a series", true, {}, {} };
  SurfaceRequest& surface = request.surface;
  OptionSpec points = number("--points-per-wave", "N", "points a wavelength along the rays", "as the profile needs",
    "Surface", surface.pointsPerWave, { "", 16.0, 10000.0 });
  OptionSpec seed{ "--seed", "N", "what varies from wave to wave is drawn from this", "1", "Surface", false, {} };
  seed.set = [&surface](const std::string& typed)
  { surface.seed = static_cast<int>(parseWhole("--seed", typed, 0, 2'000'000'000)); };
  spec.options = { outputFile("-o,--output", "surface, .vtp, or series, .pvd", request.output.file, { ".vtp", ".pvd" }),
    flag("--compress", "compress the files (smaller, slower)", "Output", request.output.compress),
    profileOption(surface),
    choice("--phase", "phase of the waves: as traced, or along straight lines (Peachey 1986)", "traced", "Surface",
      surface.straightPhase, std::vector<std::pair<std::string, bool>>{ { "traced", false }, { "straight", true } }),
    number("--time", "S", "time, s", "0", "Surface", surface.time, { "seconds" }), timesOption(surface), points,
    number("--foam-life", "S", "time until foam is gone, s", "8", "Surface", surface.foamLife, PositiveSeconds), seed };
  add(spec.options, waveOptions(request.rays, true));
  add(spec.options, rayOptions(request.rays));
  add(spec.options, seafloorOptions(request.seafloor.options));
  spec.examples =
    "  swellray surface babbage --period 6 --direction 15 --height 0.8 --time 3 -o babbage.vtp\n"
    "  swellray surface harbour.tif --period 14 --direction 135 --height 2 --profile jeschke --times 0:14:0.1 -o "
    "sea.pvd\n"
    "  swellray surface plane --period 12 --direction 270 --height 1.5 --profile vortex:threshold=0.1 -o tube.vtp\n"
    "A series that was broken off goes on where it was when the same call is made again.\n";
  spec.check = checkSurface;
  spec.run = runSurface;
  return spec;
}

}
