#pragma once

#include "Pipeline.h"

namespace swellray::cli
{

/** The camera that the request gives, by name or in the coordinates of the seafloor's file. */
scene::SceneCamera cameraOf(const Request& request, vtkImageData* seafloor);

/**
 * Draw the water of the waves that the request gives, in three dimensions: a picture, or a movie of its times; and write
 * the scene for others to draw.
 * @param title of the scene
 * @throws WorkError
 */
void renderScene(const Request& request, const std::string& title, Console& console);

}
