#include "FrameSeries.h"

#include "Failure.h"
#include "FieldValues.h"
#include "MapOutput.h"
#include "Pipeline.h"

#include <fmt/format.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <chrono>
#include <filesystem>
#include <fstream>

namespace swellray::cli
{

namespace
{

namespace fs = std::filesystem;

fs::path folderOf(const FrameSeries& series)
{
  const fs::path path(series.file->path());
  return path.parent_path() / path.stem();
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
    const vtkSmartPointer<vtkDataSet> there = readFrame(frame.string(), console);
    return fieldNumber(there, "Time") == time && fieldText(there, "CommandLine") == request.commandLine;
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

}

bool isSeries(const std::string& file)
{
  return fs::path(file).extension() == ".pvd";
}

void writeFrame(vtkDataSet* data, const OutputFile& file, const Request& request, Console& console)
{
  if (auto* grid = vtkImageData::SafeDownCast(data))
  {
    writeMap(grid, file, request, console);
    return;
  }
  vtkNew<vtkXMLPolyDataWriter> writer;
  writeXml(writer, data, file, request, console);
}

void writeFrames(std::vector<FrameSeries>& all, const TimeSeries& times, const Request& request, Console& console,
  const std::function<void(vtkDataSet*)>& said)
{
  for (const FrameSeries& series : all)
  {
    std::error_code error;
    fs::create_directories(folderOf(series), error);
    if (error)
    {
      throw WorkError(fmt::format("cannot make the folder '{}': {}", folderOf(series).string(), error.message()));
    }
  }
  const std::size_t count = times.count();
  std::size_t kept = 0;
  std::size_t made = 0;
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < count; ++i)
  {
    const double time = times.at(i);
    for (FrameSeries& series : all)
    {
      const std::string stem = fs::path(series.file->path()).stem().string();
      const std::string name = fmt::format("{}_{:06}{}", stem, i, series.ending);
      series.frames.emplace_back(time, (fs::path(stem) / name).string());
      if (isKept(folderOf(series) / name, time, request, console))
      {
        ++kept;
        continue;
      }
      vtkDataSet* data = series.make(time);
      OutputFile frame((folderOf(series) / name).string(), {});
      writeFrame(data, frame, request, console);
      frame.commit();
      if (made++ == 0)
      {
        said(data);
      }
    }
    console.progress("frames", static_cast<double>(i + 1) / static_cast<double>(count));
  }
  console.endProgress();
  for (const FrameSeries& series : all)
  {
    writeSeriesFile(*series.file, series.frames);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  console.say(fmt::format("frames   {}: {} made in {:.2f} s, {} kept", made + kept, made, seconds, kept));
}

}
