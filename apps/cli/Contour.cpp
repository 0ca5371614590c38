#include "Commands.h"
#include "OptionGroups.h"
#include "OptionKinds.h"

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
  writeLines(contours, file, request, console);
  file.commit();
  if (depths.empty())
  {
    console.warn("no contour line at the depths asked for lies in this seafloor; the file has no lines");
    return;
  }
  console.say(fmt::format("{} contour lines at {} depths, {:g} to {:g} m, {} points", contours->GetNumberOfCells(),
    depths.size(), *depths.begin(), *depths.rbegin(), contours->GetNumberOfPoints()));
  console.say(fmt::format("wrote {} (open it in ParaView)", file.path()));
}

}

CommandSpec contourSpec(Request& request)
{
  CommandSpec spec{ "contour", "draw depth contour lines into a .vtp file", true, {}, {} };
  spec.options = { outputFile("-o,--output", "contour lines, .vtp", request.output.file, { ".vtp" }) };
  spec.options.back().required = true;
  add(spec.options, { flag("--compress", "compress the file (smaller, slower)", "Output", request.output.compress) });
  add(spec.options, contourOptions(request.contour));
  add(spec.options, seafloorOptions(request.seafloor.options));
  spec.examples = "  swellray contour harbour.tif --levels 5,10,20 -o contours.vtp\n"
                  "  swellray contour harbour.tif --interval 2 --simplify 5 -o contours.vtp\n";
  spec.check = [](Request& asked) { checkContours(asked.contour); };
  spec.run = runContour;
  return spec;
}

}
