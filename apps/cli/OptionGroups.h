#pragma once

#include "Options.h"

namespace swellray::cli
{

// Groups of options that several commands share; they write into the parts of a request.

std::vector<OptionSpec> seafloorOptions(SeafloorOptions& seafloor);

/** @param required the command does nothing without a wave */
std::vector<OptionSpec> waveOptions(RayRequest& rays, bool required);

/** How rays are traced, on which current, and how heights are found: with waveOptions all that rays depend on. */
std::vector<OptionSpec> rayOptions(RayRequest& rays);

/** A depth that is the same everywhere, and gravity. */
std::vector<OptionSpec> uniformDepthOptions(IncidentWave& wave, const char* group);

/** Where the wave offshore is given, what it meets on its way to the scene, and on which current. */
std::vector<OptionSpec> offshoreOptions(RayRequest& rays);

std::vector<OptionSpec> contourOptions(ContourRequest& contour);

std::vector<OptionSpec> mapOptions(MapRequest& map);

/** Options that come before or after any command. */
std::vector<OptionSpec> commonOptions(Request& request);

/** Checks that span several of these options, and what follows from them. @throws UsageError */
void checkRays(RayRequest& rays);
void checkEarth(const Request& request);
void checkPlane(const Request& request, const char* command);
void checkContours(const ContourRequest& contour);

/** No two of these files, option and name, are the same; empty names stand for none. @throws UsageError */
void checkDifferentFiles(const std::vector<std::pair<std::string, std::string>>& files);

/** No two of the files to write are the same. @throws UsageError */
void checkOutputs(const OutputRequest& output);

/** Where a scene is seen from; --camera. */
OptionSpec cameraOption(RenderRequest& render);

}
