#include "XmlFile.h"

#include "bathymetry/FileGrid.h"
#include "bathymetry/Text.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLReader.h>

#include <new>
#include <stdexcept>

namespace swellray
{

void readXmlFile(vtkXMLReader* reader, const std::string& path, const std::string& kind)
{
  if (!reader->CanReadFile(path.c_str()))
  {
    throw std::runtime_error("no such file, or not " + kind);
  }
  // One line says what went wrong, not the reader's own report beside it.
  vtkNew<vtkCallbackCommand> failure;
  bool failed = false;
  failure->SetClientData(&failed);
  failure->SetCallback([](vtkObject*, unsigned long, void* client, void*) { *static_cast<bool*>(client) = true; });
  reader->AddObserver(vtkCommand::ErrorEvent, failure);
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  vtkInformation* info = reader->GetOutputInformation(0);
  if (info && info->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    // A header may claim more than there is; nothing is allocated before it is looked at.
    const int* extent = info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
    double nodes = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      nodes *= 1.0 + extent[2 * axis + 1] - extent[2 * axis];
    }
    if (nodes > static_cast<double>(MostNodes))
    {
      throw std::runtime_error(
        "it has " + text(nodes) + " nodes, above the limit of " + std::to_string(MostNodes / 1000000) + " million");
    }
  }
  try
  {
    reader->Update();
  }
  catch (const std::bad_alloc&)
  {
    throw std::runtime_error("it claims more points than the memory holds");
  }
  reader->RemoveObserver(failure);
  vtkDataSet* set = reader->GetOutputAsDataSet();
  if (failed || reader->GetErrorCode() != 0 || !set || set->GetNumberOfPoints() == 0)
  {
    throw std::runtime_error("the file is damaged or empty");
  }
}

}
