#include "ImageFile.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkXMLImageDataReader.h>

#include <stdexcept>

namespace swellray
{

vtkSmartPointer<vtkImageData> readImageFile(const std::string& path)
{
  vtkNew<vtkXMLImageDataReader> reader;
  if (!reader->CanReadFile(path.c_str()))
  {
    throw std::runtime_error("no such file, or not a VTK image (.vti)");
  }
  // One line says what went wrong, not the reader's own report beside it.
  vtkNew<vtkCallbackCommand> failure;
  bool failed = false;
  failure->SetClientData(&failed);
  failure->SetCallback([](vtkObject*, unsigned long, void* client, void*) { *static_cast<bool*>(client) = true; });
  reader->AddObserver(vtkCommand::ErrorEvent, failure);
  reader->SetFileName(path.c_str());
  reader->Update();
  if (failed || reader->GetErrorCode() != 0 || reader->GetOutput()->GetNumberOfPoints() == 0)
  {
    throw std::runtime_error("the file is damaged or empty");
  }
  return reader->GetOutput();
}

}
