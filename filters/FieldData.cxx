#include "FieldData.h"

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <stdexcept>

namespace swellray
{

namespace
{

template <typename Array, typename Value>
void setField(vtkDataObject* data, const char* name, const Value& value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->InsertNextValue(value);
  data->GetFieldData()->AddArray(array);
}

}

void setFieldValue(vtkDataObject* data, const char* name, double value)
{
  setField<vtkDoubleArray>(data, name, value);
}

void setFieldInteger(vtkDataObject* data, const char* name, int value)
{
  setField<vtkIntArray>(data, name, value);
}

void setFieldString(vtkDataObject* data, const char* name, const std::string& value)
{
  setField<vtkStringArray>(data, name, value);
}

std::optional<double> fieldValue(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfValues() == 0)
  {
    return {};
  }
  return array->GetComponent(0, 0);
}

double requireFieldValue(vtkDataObject* data, const char* name, const char* owner)
{
  if (const std::optional<double> value = fieldValue(data, name))
  {
    return *value;
  }
  throw std::invalid_argument(std::string("the input has no field data ") + name + "; give it the output of " + owner);
}

std::optional<std::string> fieldString(vtkDataObject* data, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
  if (!array || array->GetNumberOfValues() == 0)
  {
    return {};
  }
  return array->GetValue(0);
}

}
