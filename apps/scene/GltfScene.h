#pragma once

#include "ScenePicture.h"

#include <string>

namespace swellray::scene
{

/**
 * Write a scene as glTF 2.0, buffers within the file: a mesh `seafloor` and a mesh `sea`, metres, y up, x east, -z north,
 * with normals and a colour a point (SceneColors), and the camera of the content.
 * @param surface of vtkSwellFoam: point arrays Normals and Foam
 * @param title kept with the scene
 * @throws std::runtime_error where the file cannot be written
 */
void writeGltf(const SceneContent& content, vtkPolyData* surface, const std::string& title, const std::string& path);

}
