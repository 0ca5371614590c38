#pragma once

#include <string>
#include <vector>

namespace swellray::scene
{

// Code of the shaders, GLSL 1.50. What they read: sunDirection, perezA to perezE, skyScale (SkyModel), middle
// (luminance of a middle tone), eye (m), waterLevel, waveHeight (m), time (s), rippleHeading (rad), rippleLength, foamSize
// (of patches, m) and haze (distance in which air dims by e, m); of the vertex place (m) and normal; sunSeen (0 to 1) on
// water and land, foam (0 to 1) and bedDepth (m) on water, and opacity (0 to 1), across and along (-1 to 1) of spray.

/** Declarations of the vertex shader and what it passes on: the named values of points too, which come with MC behind their names. */
std::string vertexDeclarations(const std::vector<std::string>& values);
std::string vertexCode(const std::vector<std::string>& values);

/** What a fragment shader takes from it. */
std::string fragmentDeclarations(const std::vector<std::string>& values);

/** Functions that all fragment shaders share: the sky, ripples, noise and the tones of the picture. */
std::string sharedFunctions();

std::string skyCode();
std::string waterCode();
std::string landCode();
std::string sprayCode();

}
