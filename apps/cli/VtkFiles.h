#pragma once

#include "Console.h"
#include "OutputFile.h"
#include "Request.h"

#include <vtkSmartPointer.h>

#include <string>

class vtkDataObject;
class vtkDataSet;
class vtkImageData;
class vtkPolyData;
class vtkXMLWriter;

namespace swellray::cli
{

/** Write data to the file's hidden name, with the command line and the version. @throws WorkError */
void writeXml(
  vtkXMLWriter* writer, vtkDataObject* data, const OutputFile& file, const Request& request, Console& console);

/** Read a .vtp file. @throws WorkError */
vtkSmartPointer<vtkPolyData> readLines(const std::string& path, Console& console);

/** Read a frame of a series, .vtp or .vti. @throws WorkError */
vtkSmartPointer<vtkDataSet> readFrame(const std::string& path, Console& console);

/** Read a .vti file. @throws WorkError */
vtkSmartPointer<vtkImageData> readImage(const std::string& path, Console& console);

}
