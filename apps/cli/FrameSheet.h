#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <string>

class vtkImageData;

namespace swellray::cli
{

/** Pictures of one size in one, from the upper left corner on, each with a word in its corner. */
class FrameSheet
{
public:
  /** Size of each picture in a sheet of this size, pixels; 1 or more. */
  static std::array<int, 2> frameSize(const std::array<int, 2>& sheet, std::size_t count, std::size_t columns);

  /** @param count pictures, and @param columns of them a row; both 1 or more */
  FrameSheet(std::size_t count, std::size_t columns);

  /** Put the next picture, 8 bits RGB. @throws std::logic_error where there are more than `count` */
  void add(vtkImageData* picture, const std::string& label);

  /** Null before the first picture. */
  vtkImageData* picture() const { return this->Sheet; }

private:
  const std::size_t Count;
  const std::size_t Columns;
  std::size_t Next = 0;
  vtkSmartPointer<vtkImageData> Sheet;
};

}
