#ifndef FieldData_h
#define FieldData_h

#include <optional>
#include <string>

class vtkDataObject;

namespace swellray
{

/** Put a field data array of one number, replacing one of that name. */
void setFieldValue(vtkDataObject* data, const char* name, double value);

/** Put a field data array of one integer (int), replacing one of that name. */
void setFieldInteger(vtkDataObject* data, const char* name, int value);

/** Put a field data string, replacing one of that name. */
void setFieldString(vtkDataObject* data, const char* name, const std::string& value);

/** First number of a field data array; none where there is no such array. */
std::optional<double> fieldValue(vtkDataObject* data, const char* name);

/** @throws std::invalid_argument where there is no such array, naming it and `owner`, which should have made it */
double requireFieldValue(vtkDataObject* data, const char* name, const char* owner);

/** First string of a field data array; none where there is no such array. */
std::optional<std::string> fieldString(vtkDataObject* data, const char* name);

}

#endif
