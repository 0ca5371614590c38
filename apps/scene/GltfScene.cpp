#include "GltfScene.h"

#include "GltfMotion.h"
#include "RayLines.h"
#include "SceneColors.h"

#include "apps/drawing/Relief.h"

#include <nlohmann/json.hpp>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
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

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <utility>

namespace swellray::scene
{

namespace
{

constexpr vtkIdType MostReliefNodes = 100000;

constexpr std::size_t SeaMesh = 1; // after the seafloor

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

// Lines or points in the axes of glTF.
vtkSmartPointer<vtkPolyData> turnedShape(vtkPolyData* data)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double v[3];
    data->GetPoint(i, v);
    points->InsertNextPoint(turned(v).data());
    vertices->InsertNextCell(1, &i);
  }
  auto shape = vtkSmartPointer<vtkPolyData>::New();
  shape->SetPoints(points);
  if (data->GetNumberOfLines() > 0)
  {
    shape->SetLines(data->GetLines());
  }
  else
  {
    shape->SetVerts(vertices);
  }
  return shape;
}

void addMesh(vtkRenderer* renderer, vtkPolyData* mesh, const drawing::Rgb& color = { 1.0, 1.0, 1.0 })
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  renderer->AddActor(actor);
}

constexpr drawing::Rgb RayColor{ 0.85, 0.33, 0.1 };

// The nodes of VTK's file that have a mesh, by the mesh.
std::vector<std::size_t> nodesOfMeshes(const nlohmann::json& gltf)
{
  std::vector<std::size_t> nodes(gltf.at("meshes").size());
  for (std::size_t i = 0; i < gltf.at("nodes").size(); ++i)
  {
    const auto& node = gltf["nodes"][i];
    if (node.contains("mesh"))
    {
      nodes.at(node["mesh"].get<std::size_t>()) = i;
    }
  }
  return nodes;
}

}

GltfScene::GltfScene(
  const SceneContent& content, const std::string& title, double period, const std::string& commandLine)
  : Content(content)
  , Title(title)
  , Period(period)
  , CommandLine(commandLine)
{
}

void GltfScene::setRays(vtkPolyData* rays)
{
  this->Rays = turnedShape(rayLines(rays, this->Content.waterLevel + this->Content.waveHeight));
}

void GltfScene::add(vtkPolyData* surface, double time, vtkPolyData* spray)
{
  Frame frame;
  frame.time = time;
  const vtkIdType count = surface->GetNumberOfPoints();
  if (this->Frames.empty())
  {
    vtkDataArray* foam = surface->GetPointData()->GetArray("Foam");
    this->Sea = turnedMesh(
      surface, [&](vtkIdType i) { return SceneColors::water(foam->GetComponent(i, 0)); }, SceneColors::WaterOpacity);
  }
  else if (count != this->Sea->GetNumberOfPoints())
  {
    throw std::runtime_error("the times of a scene are to be of one sheet of points");
  }
  vtkDataArray* normals = surface->GetPointData()->GetArray("Normals");
  for (vtkIdType i = 0; i < count; ++i)
  {
    double v[3];
    surface->GetPoint(i, v);
    double n[3];
    normals->GetTuple(i, n);
    for (std::size_t j = 0; j < 3; ++j)
    {
      frame.places.push_back(static_cast<float>(turned(v)[j]));
      frame.normals.push_back(static_cast<float>(turned(n)[j]));
    }
  }
  if (spray && spray->GetNumberOfPoints() > 0)
  {
    frame.spray = turnedShape(spray);
  }
  this->Frames.push_back(std::move(frame));
}

// What VTK does not say: names, materials, what the scene is, and how it moves.
void GltfScene::complete(const std::string& path, const std::vector<std::string>& names) const
{
  nlohmann::json gltf;
  std::ifstream in(path, std::ios::binary);
  try
  {
    in >> gltf;
    in.close();
    const std::vector<std::size_t> nodes = nodesOfMeshes(gltf);
    for (std::size_t i = 0; i < names.size(); ++i)
    {
      auto& mesh = gltf.at("meshes").at(i);
      mesh["name"] = names[i];
      auto& material = gltf.at("materials").at(mesh.at("primitives").at(0).at("material").get<std::size_t>());
      material["name"] = names[i];
      material["doubleSided"] = true;
      material["pbrMetallicRoughness"]["roughnessFactor"] = names[i] == "sea" ? 0.15 : 1.0;
      material["alphaMode"] = names[i] == "sea" ? "BLEND" : "OPAQUE";
      gltf.at("nodes").at(nodes.at(i))["name"] = names[i];
    }
    gltf.at("scenes").at(0)["name"] = this->Title;
    gltf["asset"]["generator"] = "Swellray";
    if (!this->CommandLine.empty())
    {
      gltf["asset"]["extras"]["CommandLine"] = this->CommandLine;
    }
    if (this->Frames.size() > 1)
    {
      this->animate(gltf, nodes);
    }
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

void GltfScene::animate(nlohmann::json& gltf, const std::vector<std::size_t>& nodes) const
{
  const std::size_t count = this->Frames.size();
  const double between = this->Frames[1].time - this->Frames[0].time;
  const double waves = between * static_cast<double>(count) / this->Period;
  constexpr double Whole = 1e-6;
  const bool loops = std::abs(waves - std::round(waves)) < Whole;
  std::vector<float> times;
  for (std::size_t i = 0; i < count + (loops ? 1 : 0); ++i)
  {
    times.push_back(static_cast<float>(between * static_cast<double>(i)));
  }
  GltfMotion motion(gltf);
  const std::size_t clock = motion.addNumbers(times, "SCALAR");

  // The first time is the mesh itself, each other one a target of its own.
  nlohmann::json targets = nlohmann::json::array();
  const auto change = [&](const std::vector<float>& now, const std::vector<float>& first)
  {
    std::vector<float> by(now.size());
    std::transform(now.begin(), now.end(), first.begin(), by.begin(), std::minus<float>());
    return motion.addNumbers(by, "VEC3");
  };
  for (std::size_t i = 1; i < count; ++i)
  {
    targets.push_back({ { "POSITION", change(this->Frames[i].places, this->Frames[0].places) },
      { "NORMAL", change(this->Frames[i].normals, this->Frames[0].normals) } });
  }
  auto& sea = gltf["meshes"][SeaMesh];
  sea["primitives"][0]["targets"] = targets;
  sea["weights"] = std::vector<float>(count - 1, 0.0f);
  std::vector<float> weights(times.size() * (count - 1), 0.0f);
  for (std::size_t i = 1; i < count; ++i)
  {
    weights[i * (count - 1) + i - 1] = 1.0f;
  }
  motion.follow(nodes[SeaMesh], "weights", clock, motion.addNumbers(weights, "SCALAR"), "LINEAR");

  // Spray is there from its time to the next: at others it has no size.
  std::size_t mesh = SeaMesh + (this->Rays ? 2 : 1);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (this->Frames[i].spray)
    {
      std::vector<float> sizes(3 * times.size(), 0.0f);
      std::fill_n(sizes.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, 1.0f);
      if (i == 0 && loops)
      {
        std::fill_n(sizes.end() - 3, 3, 1.0f);
      }
      if (i > 0)
      {
        gltf["nodes"][nodes[mesh]]["scale"] = { 0.0, 0.0, 0.0 };
      }
      motion.follow(nodes[mesh], "scale", clock, motion.addNumbers(sizes, "VEC3"), "STEP");
      ++mesh;
    }
  }
  motion.finish("waves");
}

void GltfScene::write(const std::string& path) const
{
  const SceneContent& content = this->Content;
  const SceneColors colors(content.seafloor, content.waterLevel);
  const vtkSmartPointer<vtkPolyData> relief = drawing::reliefOf(content.seafloor, MostReliefNodes);
  vtkDataArray* elevation = relief->GetPointData()->GetArray("Elevation");
  vtkNew<vtkRenderer> renderer;
  std::vector<std::string> names{ "seafloor", "sea" };
  addMesh(renderer,
    turnedMesh(
      relief,
      [&](vtkIdType i)
      {
        const double z = elevation->GetComponent(i, 0);
        return colors.bed(std::isfinite(z) ? z : 0.0);
      },
      1.0));
  addMesh(renderer, this->Sea);
  if (this->Rays)
  {
    addMesh(renderer, this->Rays, RayColor);
    names.emplace_back("rays");
  }
  for (const Frame& frame : this->Frames)
  {
    if (frame.spray)
    {
      addMesh(renderer, frame.spray);
      names.emplace_back("spray");
    }
  }

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
  this->complete(path, names);
}

}
