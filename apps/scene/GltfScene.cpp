#include "GltfScene.h"

#include "SceneColors.h"

#include "apps/drawing/Relief.h"

#include <nlohmann/json.hpp>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkGLTFExporter.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTriangleFilter.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <stdexcept>

namespace swellray::scene
{

namespace
{

constexpr vtkIdType MostReliefNodes = 100000;

// East, north, up to the axes of glTF.
std::array<double, 3> turned(const double v[3])
{
  return { v[0], v[2], -v[1] };
}

// Triangles of the data in the axes of glTF, with a colour a point.
vtkSmartPointer<vtkPolyData> turnedMesh(
  vtkPolyData* data, const std::function<drawing::Rgb(vtkIdType)>& colorOf, double opacity)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(data);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  vtkPolyData* from = triangles->GetOutput();
  vtkDataArray* normals = from->GetPointData()->GetArray("Normals");
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  vtkNew<vtkFloatArray> directions;
  directions->SetName("NORMAL"); // that the exporter looks for
  directions->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Colors");
  colors->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < from->GetNumberOfPoints(); ++i)
  {
    double v[3];
    from->GetPoint(i, v);
    points->InsertNextPoint(turned(v).data());
    normals->GetTuple(i, v);
    directions->InsertNextTuple(turned(v).data());
    const drawing::Rgb color = colorOf(i);
    colors->InsertNextTuple4(std::round(255.0 * color[0]), std::round(255.0 * color[1]), std::round(255.0 * color[2]),
      std::round(255.0 * opacity));
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(from->GetPolys());
  mesh->GetPointData()->SetNormals(directions);
  mesh->GetPointData()->SetScalars(colors);
  return mesh;
}

void addMesh(vtkRenderer* renderer, vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

// What VTK does not say: names, materials, and what the scene is.
void complete(const std::string& path, const std::string& title)
{
  nlohmann::json gltf;
  std::ifstream in(path, std::ios::binary);
  try
  {
    in >> gltf;
    in.close();
    const char* const names[] = { "seafloor", "sea" };
    for (std::size_t i = 0; i < 2; ++i)
    {
      auto& mesh = gltf.at("meshes").at(i);
      mesh["name"] = names[i];
      auto& material = gltf.at("materials").at(mesh.at("primitives").at(0).at("material").get<std::size_t>());
      material["name"] = names[i];
      material["doubleSided"] = true;
      material["pbrMetallicRoughness"]["roughnessFactor"] = i == 0 ? 1.0 : 0.15;
      material["alphaMode"] = i == 0 ? "OPAQUE" : "BLEND";
    }
    for (auto& node : gltf.at("nodes"))
    {
      if (node.contains("mesh"))
      {
        node["name"] = names[node["mesh"].get<std::size_t>()];
      }
    }
    gltf.at("scenes").at(0)["name"] = title;
    gltf["asset"]["generator"] = "Swellray";
  }
  catch (const nlohmann::json::exception&)
  {
    throw std::runtime_error("it could not be written whole");
  }
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out << gltf.dump();
  out.close();
  if (!out)
  {
    throw std::runtime_error("it could not be written whole");
  }
}

}

void writeGltf(const SceneContent& content, vtkPolyData* surface, const std::string& title, const std::string& path)
{
  const SceneColors colors(content.seafloor, content.waterLevel);
  const vtkSmartPointer<vtkPolyData> relief = drawing::reliefOf(content.seafloor, MostReliefNodes);
  vtkDataArray* elevation = relief->GetPointData()->GetArray("Elevation");
  vtkDataArray* foam = surface->GetPointData()->GetArray("Foam");
  vtkNew<vtkRenderer> renderer;
  addMesh(renderer,
    turnedMesh(
      relief,
      [&](vtkIdType i)
      {
        const double z = elevation->GetComponent(i, 0);
        return colors.bed(std::isfinite(z) ? z : 0.0);
      },
      1.0));
  addMesh(renderer,
    turnedMesh(
      surface, [&](vtkIdType i) { return SceneColors::water(foam->GetComponent(i, 0)); }, SceneColors::WaterOpacity));

  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(turned(content.camera.eye.data()).data());
  camera->SetFocalPoint(turned(content.camera.focus.data()).data());
  camera->SetViewUp(turned(content.camera.up.data()).data());
  camera->SetViewAngle(content.camera.angle);
  const double far = 10.0 *
    std::hypot(content.camera.eye[0] - content.camera.focus[0], content.camera.eye[1] - content.camera.focus[1],
      content.camera.eye[2] - content.camera.focus[2]);
  camera->SetClippingRange(1e-4 * far, far);

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(content.width, content.height);
  window->AddRenderer(renderer);
  vtkNew<vtkGLTFExporter> exporter;
  exporter->SetRenderWindow(window);
  exporter->SetFileName(path.c_str());
  exporter->InlineDataOn();
  exporter->SaveNormalOn();
  exporter->Write();
  complete(path, title);
}

}
