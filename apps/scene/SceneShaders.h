#pragma once

#include <string>

namespace swellray::scene
{

// Code of the shaders, GLSL 1.50. What they read: sunDirection, perezA to perezE, skyScale (SkyModel), middle
// (luminance of a middle tone), eye (m), waterLevel, waveHeight (m), time (s), rippleHeading (rad), rippleLength, foamSize (of patches, m) and
// haze (distance in which air dims by e, m); of the vertex place (m), normal, foam (0 to 1) and bedDepth (m).

/** Declarations and functions of the vertex shader, and what it passes on. */
std::string vertexDeclarations(bool isWater);
std::string vertexCode(bool isWater);

/** Functions that all fragment shaders share: the sky, ripples, noise and the tones of the picture. */
std::string sharedFunctions();

std::string skyCode();
std::string waterCode();
std::string landCode();

}
