#include "Commands.h"
#include "OptionGroups.h"
#include "OptionKinds.h"

#include "LineOutput.h"
#include "Pipeline.h"

#include <fmt/format.h>

#include <vtkCellData.h>
#include <vtkPolyData.h>

#include <set>

namespace swellray::cli
{

namespace
{

void runContour(const Request& request, Console& console)
{
  OutputFile file(request.output.file, inputFiles(request));
  Pipeline pipeline(request, console);
  pipeline.readSeafloor();
  vtkPolyData* contours = pipeline.makeContours(request.seafloor.options.waterLevel);
  std::set<double> depths;
  if (vtkDataArray* array = contours->GetCellData()->GetArray("Depth"))
  {
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      depths.insert(array->GetComponent(i, 0));
    }
  }
  writeLines(contours, "contours", file, request, console);
  file.commit();
  if (depths.empty())
  {
    console.warn("no contour line at the depths asked for lies in this seafloor; the file has no lines");
    return;
  }
  console.say(fmt::format("{} contour lines at {} depths, {:g} to {:g} m, {} points", contours->GetNumberOfCells(),
    depths.size(), *depths.begin(), *depths.rbegin(), contours->GetNumberOfPoints()));
  console.say(fmt::format("wrote {0}; open with: {1} {0}", file.path(), viewerOf(file.path())));
}

}

CommandSpec contourSpec(Request& request)
{
  CommandSpec spec{ "contour", "draw depth contour lines into a file", true, {}, {} };
  spec.options = { outputFile(
    "-o,--output", "contour lines, .vtp, .gpkg or .geojson", request.output.file, lineEndings()) };
  spec.options.back().required = true;
  add(spec.options, lineOptions(request.output));
  add(spec.options, contourOptions(request.contour));
  add(spec.options, seafloorOptions(request.seafloor.options));
  spec.examples = "  swellray contour harbour.tif --levels 5,10,20 -o contours.vtp\n"
                  "  swellray contour harbour.tif --interval 2 --simplify 5 -o contours.gpkg\n";
  spec.check = [](Request& asked)
  {
    checkContours(asked.contour);
    checkLines(asked.output);
  };
  spec.run = runContour;
  return spec;
}

}
