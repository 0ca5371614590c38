#pragma once

class vtkImageData;
class vtkSwellSeaFunction;

namespace swellray::cli
{

class Console;
class OutputFile;
struct Request;

/**
 * Heights as an image: .png with 16 bits, 0 to 65535 from -range to range; .tif in metres, 32-bit floating point.
 * @param range m, > 0
 * @throws WorkError
 */
void writeHeightImage(vtkImageData* image, double range, const Request& request, const OutputFile& file);

/** Normals as an image of 8 bits a colour, (n + 1)/2 each; x, y, z are red, green, blue. @throws WorkError */
void writeNormalImage(vtkImageData* image, const Request& request, const OutputFile& file);

/**
 * Picture of the sea from above its surface, by ray marching its implicit function: sky and sun reflected by Fresnel's law,
 * the water's own colour, haze. Needs no display. @throws WorkError
 */
void writeSeaPicture(vtkSwellSeaFunction* sea, const Request& request, const OutputFile& file, Console& console);

}
