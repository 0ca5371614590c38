#ifndef ImageFile_h
#define ImageFile_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace swellray
{

/**
 * The image in a .vti file.
 * @throws std::runtime_error what went wrong, without the file's name
 */
vtkSmartPointer<vtkImageData> readImageFile(const std::string& path);

}

#endif
