#include "FrameSeries.h"

#include "Failure.h"
#include "FieldValues.h"
#include "MapOutput.h"
#include "Pipeline.h"
#include "VtkFiles.h"

#include "filters/AlgorithmExecution.h"

#include <fmt/format.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <thread>

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

// A frame that is to be made.
struct FrameWork
{
  FrameSeries* series = nullptr;
  std::string file;
  double time = 0.0;
  bool first = false; // of its series
};

// Let workers do work(i, worker) for all i below n, each in the order of i. Of what they throw the first, by i, comes out.
void shareOut(std::size_t n, std::size_t workers, const std::function<void(std::size_t, std::size_t)>& work)
{
  std::atomic<std::size_t> next{ 0 };
  std::mutex mutex;
  std::exception_ptr failure;
  std::size_t failedAt = n;
  const auto run = [&](std::size_t worker)
  {
    for (std::size_t i = next++; i < n; i = next++)
    {
      try
      {
        work(i, worker);
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        if (i < failedAt)
        {
          failure = std::current_exception();
          failedAt = i;
        }
        next = n;
      }
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t worker = 1; worker < std::min(workers, n); ++worker)
  {
    threads.emplace_back(
      [&run, worker]
      {
        const WritingThread writing;
        const OneThread alone;
        run(worker);
      });
  }
  {
    const std::unique_ptr<const OneThread> alone(threads.empty() ? nullptr : new OneThread);
    run(0);
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  if (failure)
  {
    std::rethrow_exception(failure);
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

std::size_t frameWorkers(std::size_t frames)
{
  // Each holds a frame and its scratch.
  constexpr std::size_t most = 8;
  return std::clamp<std::size_t>(
    std::min(frames, static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads())), 1, most);
}

void writeFrames(std::vector<FrameSeries>& all, const TimeSeries& times, const Request& request, Console& console,
  std::size_t workers, const std::function<void(vtkDataSet*)>& said)
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
  std::vector<FrameWork> work;
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
      }
      else
      {
        const bool first =
          std::none_of(work.begin(), work.end(), [&](const FrameWork& frame) { return frame.series == &series; });
        work.push_back({ &series, (folderOf(series) / name).string(), time, first });
      }
    }
  }
  std::mutex mutex;
  std::size_t made = 0;
  const auto make = [&](std::size_t i, std::size_t worker)
  {
    vtkDataSet* data = work[i].series->make(worker, work[i].time);
    OutputFile frame(work[i].file, {});
    writeFrame(data, frame, request, console);
    frame.commit();
    const std::lock_guard<std::mutex> lock(mutex);
    if (i == 0)
    {
      said(data);
    }
    console.progress("frames", static_cast<double>(kept + ++made) / static_cast<double>(count * all.size()));
  };
  // Frames share arrays that do not move, and writing finds their ranges; so the first of each series is written alone.
  const auto others =
    std::stable_partition(work.begin(), work.end(), [](const FrameWork& frame) { return frame.first; });
  const auto alone = static_cast<std::size_t>(others - work.begin());
  for (std::size_t i = 0; i < alone; ++i)
  {
    make(i, 0);
  }
  shareOut(work.size() - alone, workers, [&](std::size_t i, std::size_t worker) { make(alone + i, worker); });
  console.endProgress();
  for (const FrameSeries& series : all)
  {
    writeSeriesFile(*series.file, series.frames);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  console.say(fmt::format("frames   {}: {} made in {:.2f} s, {} kept", made + kept, made, seconds, kept));
}

}
