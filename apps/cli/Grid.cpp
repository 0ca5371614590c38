#include "Commands.h"

#include "MapOutput.h"
#include "OptionGroups.h"
#include "OptionKinds.h"
#include "Pipeline.h"

#include "bathymetry/SeafloorReport.h"

#include <fmt/format.h>

#include <vtkImageData.h>

#include <algorithm>

namespace swellray::cli
{

namespace
{

void runGrid(const Request& request, Console& console)
{
  OutputFile file(request.output.file, inputFiles(request));
  Pipeline pipeline(request, console);
  vtkSwellSeafloorReader* reader = pipeline.readSeafloor(Pipeline::Notes::Keep);
  const SeafloorReport& report = *reader->GetReport();
  writeMap(reader->GetOutput(), file, request, console);
  file.commit();
  for (const std::string& note : report.notes)
  {
    console.say("note     " + note);
  }
  if (report.soundings)
  {
    for (const auto& [label, text] : report.soundings->lines())
    {
      console.say(fmt::format("{:<16}  {}", label, text));
    }
  }
  console.say(fmt::format("wrote {}, {} x {} nodes of {:g} x {:g} m, {:.3g} % without data", file.path(),
    report.columns, report.rows, report.spacing.x, report.spacing.y, 100.0 * report.noDataShare));
}

}

CommandSpec gridSpec(Request& request)
{
  SeafloorOptions& seafloor = request.seafloor.options;
  CommandSpec spec{ "grid", "bring scattered soundings to a grid, .tif, .nc or .vti", true, {}, {} };
  spec.options = { outputFile(
    "-o,--output", "elevations on a grid, .tif, .nc or .vti", request.output.file, { ".tif", ".nc", ".vti" }) };
  spec.options.back().required = true;
  add(spec.options,
    { number("--spacing", "M", "distance of the nodes, m", "about that of the soundings", "Grid", seafloor.resample,
        PositiveMetres),
      flag("--cross-validate", "measure the error by leaving out a tenth of the soundings at a time", "Grid",
        seafloor.crossValidate),
      flag("--compress", "compress a .vti (smaller, slower)", "Output", request.output.compress) });
  std::vector<OptionSpec> shared = seafloorOptions(seafloor);
  // The same as --spacing.
  shared.erase(std::remove_if(shared.begin(), shared.end(),
                 [](const OptionSpec& option) { return option.longName() == "--resample"; }),
    shared.end());
  add(spec.options, shared);
  spec.examples = "  swellray grid survey.xyz --spacing 5 -o survey.tif\n"
                  "  swellray grid lidar.csv --crs EPSG:32750 --max-gap 50 --drop-outliers -o lidar.nc\n"
                  "  swellray grid survey.nc --cross-validate -o survey.vti\n";
  spec.run = runGrid;
  return spec;
}

}
