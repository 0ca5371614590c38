#include "FieldValues.h"

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

namespace swellray::cli
{

std::optional<double> fieldNumber(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  if (array && array->GetNumberOfTuples() > 0)
  {
    return array->GetComponent(0, 0);
  }
  return {};
}

std::string fieldText(vtkDataObject* data, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
  return array && array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0)) : std::string();
}

void setFieldText(vtkDataObject* data, const char* name, const std::string& text)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  data->GetFieldData()->AddArray(array);
}

Georeference georeferenceOf(vtkDataObject* data)
{
  return Georeference(fieldText(data, "CRS"),
    { fieldNumber(data, "OriginLongitude").value_or(0.0), fieldNumber(data, "OriginLatitude").value_or(0.0) },
    { fieldNumber(data, "OriginX").value_or(0.0), fieldNumber(data, "OriginY").value_or(0.0) });
}

}
