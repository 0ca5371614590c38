#pragma once

#include <cstddef>
#include <string>

class vtkImageData;

namespace swellray::cli
{

class OutputFile;

/** True for the name of numbered pictures: %d, or %04d for four digits, stands for the number. */
bool isNumbered(const std::string& file);

/** The name of a picture of the series. */
std::string numberedName(const std::string& file, std::size_t number);

/** The call that a picture was made by, and its time: kept in .png as text. */
struct PictureOrigin
{
  std::string commandLine;
  double time = 0.0; ///< s
};

/** Store a picture, .png or .jpg by the name of the file. @throws WorkError */
void writePicture(vtkImageData* picture, const PictureOrigin& origin, const OutputFile& file);

/** The call that a picture was made by; empty where it does not say, as a .jpg cannot. @throws WorkError not a .png */
std::string pictureCommand(const std::string& path);

/** True where the file is a whole picture of this origin. */
bool isPictureOf(const std::string& path, const PictureOrigin& origin);

}
