#ifndef SurfaceSettings_h
#define SurfaceSettings_h

#include <string>

class vtkInformation;

namespace swellray
{

/** NAME:key=value,... of a name, which may have some already, and further parameters. */
std::string sectionSpec(const std::string& name, const std::string& parameters);

/** @throws std::invalid_argument naming the property unless it is above 0 and finite */
void requirePositive(const char* name, double value);

/**
 * TIME_STEPS and TIME_RANGE of an output.
 * @param range first and last, s
 * @throws std::invalid_argument where it ends before it begins, or has more than a million steps
 */
void setTimeSteps(vtkInformation* output, const double range[2], double step);

/** Time that the pipeline asks for, otherwise this one. @throws std::invalid_argument where it is not finite */
double requestedTime(vtkInformation* output, double otherwise);

/** Rays and seafloor are the same at all times, and must not be made again for another frame. */
void askAtNoTime(vtkInformation* input);

/**
 * Points a wavelength: the setting, or as many as the section asks for where it is 0.
 * @throws std::invalid_argument from below 16
 */
double pointsPerWave(double setting, double ofSection);

}

#endif
