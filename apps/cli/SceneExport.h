#pragma once

#include "OutputFile.h"
#include "Pipeline.h"

#include "apps/scene/ScenePicture.h"

namespace swellray::cli
{

/** True for the name of a page, .html. */
bool isPage(const std::string& file);

/** Where a page finds vtk.js. @throws WorkError where there is none, saying how to get it */
std::string findPageLibrary();

/**
 * Write the scene for others to draw, by the ending of its file: glTF, or a page that plays the waves.
 * @param file is committed
 * @throws WorkError
 */
void exportScene(const Request& request, Pipeline& pipeline, const scene::SceneContent& content,
  const std::string& title, Console& console, OutputFile& file);

}
