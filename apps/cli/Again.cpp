#include "CommandLine.h"
#include "Commands.h"
#include "Failure.h"
#include "FieldValues.h"
#include "FilterRun.h"
#include "OptionKinds.h"
#include "PictureSeries.h"
#include "ShellWords.h"

#include "bathymetry/FileHistory.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <vtkDataObject.h>
#include <vtkNew.h>
#include <vtkSMPTools.h>
#include <vtkXMLGenericDataObjectReader.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>

namespace swellray::cli
{

namespace
{

namespace fs = std::filesystem;

/** How a file was made. */
struct Record
{
  std::string commandLine;
  std::string version; ///< empty where it does not say
};

// The first frame of a series, which says how all of them were made.
std::string firstFrame(const std::string& series)
{
  std::ifstream file(series);
  const std::string mark = "file=\"";
  for (std::string line; std::getline(file, line);)
  {
    const auto begin = line.find(mark);
    if (begin != std::string::npos)
    {
      const auto end = line.find('"', begin + mark.size());
      return (fs::path(series).parent_path() / line.substr(begin + mark.size(), end - begin - mark.size())).string();
    }
  }
  throw WorkError(fmt::format("cannot read '{}': it has no frames", series));
}

Record readVtkFile(const std::string& path, Console& console)
{
  vtkNew<vtkXMLGenericDataObjectReader> reader;
  reader->SetFileName(path.c_str());
  try
  {
    runFilter(reader, "reading", console);
  }
  catch (const WorkError&)
  {
    throw WorkError(fmt::format("cannot read '{}': it is no VTK file, or damaged", path));
  }
  vtkDataObject* data = reader->GetOutputDataObject(0);
  return { fieldText(data, "CommandLine"), fieldText(data, "SwellrayVersion") };
}

// From the JSON that a scene holds: whole in .gltf, between these marks in a page.
std::string sceneCommand(const std::string& path, bool page)
{
  std::ifstream in(path, std::ios::binary);
  std::string text{ std::istreambuf_iterator<char>(in), {} };
  if (page)
  {
    const std::string mark = "id=\"header\">";
    const auto begin = text.find(mark);
    const auto end = text.find("</script>", begin);
    text = begin == std::string::npos || end == std::string::npos
      ? std::string()
      : text.substr(begin + mark.size(), end - begin - mark.size());
  }
  try
  {
    const auto scene = nlohmann::json::parse(text);
    return page ? scene.at("commandLine").get<std::string>()
                : scene.at("asset").at("extras").at("CommandLine").get<std::string>();
  }
  catch (const nlohmann::json::exception&)
  {
    return {};
  }
}

// SWAN's spectra say who made them in a comment at their beginning.
std::string spectraCommand(const std::string& path)
{
  std::ifstream in(path);
  std::string line;
  for (int i = 0; i < 10 && std::getline(in, line); ++i)
  {
    const auto at = line.find(": swellray ");
    if (line.rfind('$', 0) == 0 && at != std::string::npos)
    {
      return line.substr(at + 2);
    }
  }
  return {};
}

Record readRecord(const std::string& path, Console& console)
{
  if (!std::ifstream(path).good())
  {
    throw WorkError(fmt::format("cannot read '{}': no such file, or it may not be read", path));
  }
  const std::string ending = fs::path(path).extension().string();
  if (ending == ".pvd")
  {
    return readRecord(firstFrame(path), console);
  }
  if (ending == ".vtp" || ending == ".vti")
  {
    return readVtkFile(path, console);
  }
  if (ending == ".png")
  {
    return { pictureCommand(path), {} };
  }
  if (ending == ".gltf" || ending == ".html")
  {
    return { sceneCommand(path, ending == ".html"), {} };
  }
  if (ending == ".sp2")
  {
    return { spectraCommand(path), {} };
  }
  if (ending == ".csv" || ending == ".jpg" || ending == ".ogv")
  {
    throw WorkError(fmt::format(
      "'{}' does not say how it was made, as {} files cannot: take another output of the call", path, ending));
  }
  try
  {
    return { readHistory(path), {} };
  }
  catch (const std::runtime_error& error)
  {
    throw WorkError(fmt::format("cannot read '{}': {}", path, error.what()));
  }
}

void moveOutputs(Request& request, const std::string& folder)
{
  OutputRequest& output = request.output;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
  {
    throw WorkError(fmt::format("cannot make the folder '{}': {}", folder, error.message()));
  }
  SeaRequest& sea = request.sea;
  for (std::string* path :
    { &output.file, &output.crests, &output.breakerLine, &output.spray, &output.foam, &output.scene, &output.map,
      &output.table, &output.spectra, &output.elevations, &sea.heightImage, &sea.normalImage, &sea.picture })
  {
    if (!path->empty())
    {
      *path = (fs::path(folder) / fs::path(*path).filename()).string();
    }
  }
}

void runAgain(const Request& request, Console& console)
{
  const AgainRequest& again = request.again;
  const Record record = readRecord(again.file, console);
  const std::string program = "swellray ";
  if (record.commandLine.compare(0, program.size(), program) != 0)
  {
    throw WorkError(fmt::format("'{}' does not say how it was made: it has no command line of swellray", again.file));
  }
  if (again.show)
  {
    std::printf("%s\n", record.commandLine.c_str());
    return;
  }
  console.say("again    " + record.commandLine);
  if (!record.version.empty() && record.version != SWELLRAY_VERSION)
  {
    console.warn(fmt::format("'{}' was made by version {}; this is {}", again.file, record.version, SWELLRAY_VERSION));
  }
  std::optional<Call> call;
  try
  {
    call = readCommandLine(splitWords(record.commandLine));
  }
  catch (const std::invalid_argument& error)
  {
    throw WorkError(fmt::format("'{}' has a damaged command line: {}", again.file, error.what()));
  }
  if (!call)
  {
    return;
  }
  if (!again.folder.empty())
  {
    moveOutputs(call->request, again.folder);
  }
  if (request.threads == 0 && call->request.threads > 0)
  {
    vtkSMPTools::Initialize(call->request.threads);
  }
  Console spoken(request.quiet || call->request.quiet);
  call->run(call->request, spoken);
}

}

CommandSpec againSpec(Request& request)
{
  CommandSpec spec{ "again", "make an output again, by the command line that it carries", false, {}, {} };
  AgainRequest& again = request.again;
  spec.file = { "FILE", "an output: .vtp, .vti, .pvd, .nc, .tif, .gpkg, .geojson, .sp2, .png, .html, .gltf",
    &again.file };
  spec.options = { text("--into", "FOLDER", "write the outputs into this folder, under the names they had",
                     "where they were written", "Output", again.folder),
    flag("--show", "only print the command line", "Output", again.show) };
  spec.examples = "  swellray again rays.vtp\n"
                  "  swellray again heights.nc --into check\n"
                  "  swellray again sea.pvd --show\n"
                  "Names of files in a command line count from the folder in which the call is made.\n";
  spec.run = runAgain;
  return spec;
}

}
