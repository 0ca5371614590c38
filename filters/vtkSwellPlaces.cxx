#include "vtkSwellPlaces.h"

#include "AlgorithmExecution.h"
#include "GeoreferenceField.h"

#include <vtkDataObject.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>

#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSwellPlaces);

namespace
{

void checkFileCoordinates(const std::vector<glm::dvec2>& points, bool geographic)
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto name = [&] { return "point " + std::to_string(i) + " of " + std::to_string(points.size()); };
    if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y))
    {
      throw std::invalid_argument(name() + " has a coordinate that is no number");
    }
    if (geographic && std::abs(points[i].y) > 90.0)
    {
      throw std::invalid_argument(name() + " has the latitude " + std::to_string(points[i].y) +
        ", which must be within -90 to 90; the coordinates are longitude and latitude");
    }
  }
}

}

vtkSwellPlaces::vtkSwellPlaces()
{
  this->SetNumberOfInputPorts(2);
}

int vtkSwellPlaces::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkDataObject");
  return 1;
}

int vtkSwellPlaces::RequestData(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPointSet* input = vtkPointSet::GetData(inputVector[0]);
  vtkDataObject* scene = vtkDataObject::GetData(inputVector[1]);
  vtkPointSet* output = vtkPointSet::GetData(outputVector);
  try
  {
    output->ShallowCopy(input);
    const swellray::Georeference georeference = swellray::georeferenceOf(scene);
    const bool toScene = this->Way == FILE_TO_SCENE;
    const vtkIdType count = input->GetNumberOfPoints();
    std::vector<glm::dvec2> from(static_cast<std::size_t>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      double point[3];
      input->GetPoint(i, point);
      from[static_cast<std::size_t>(i)] = { point[0], point[1] };
    }
    if (toScene)
    {
      checkFileCoordinates(from, georeference.kind() == swellray::GeoreferenceKind::Geographic);
    }
    std::vector<glm::dvec2> to(from.size());
    swellray::parallelFor(from.size(),
      [&](std::size_t begin, std::size_t end)
      {
        if (toScene)
        {
          georeference.fromFile(end - begin, from.data() + begin, to.data() + begin);
        }
        else
        {
          georeference.toFile(end - begin, from.data() + begin, to.data() + begin);
        }
      });
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      double point[3];
      input->GetPoint(i, point);
      const glm::dvec2& place = to[static_cast<std::size_t>(i)];
      points->SetPoint(i, place.x, place.y, point[2]);
    }
    output->SetPoints(points);
    if (toScene)
    {
      swellray::setGeoreference(output, georeference);
    }
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkSwellPlaces::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Way: " << (this->Way == SCENE_TO_FILE ? "scene to file" : "file to scene") << "\n";
}
