#include "ScenePicture.h"

#include "SceneShaders.h"
#include "SprayStreaks.h"

#include "apps/drawing/Relief.h"
#include "sim/Angles.h"
#include "sim/Dispersion.h"

#include <vtkCamera.h>
#include <vtkDataObject.h>
#include <vtkDiskSource.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkImageShrink3D.h>
#include <vtkLight.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkShaderProperty.h>
#include <vtkSphereSource.h>
#include <vtkUniforms.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>

namespace swellray::scene
{

namespace
{

// Drawn larger and averaged down: smooth edges on any driver.
constexpr int Oversampling = 2;
constexpr int LargestOversampled = 4000;

// Nodes of the seafloor are not closer than pixels where it is nearest to the eye.
constexpr double MostReliefNodes = 1000000;
constexpr double LeastReliefNodes = 40000;

// How far the open sea goes on beyond the scene: to the horizon of somebody on a high shore, and over many scenes.
constexpr double LeastHorizon = 12000.0; // m
constexpr double ScenesToHorizon = 8.0;

// The open sea lies under the troughs of the waves, wave heights.
constexpr double OpenSeaDepth = 0.55;

// Over which air takes two thirds of the light: on a clear day, and clearer where the scene would be lost in it.
constexpr double Visibility = 20000.0; // m
constexpr double ScenesVisible = 12.0;

// Where the sky before the camera is brighter than a quarter turn from the sun, so much of that is taken back.
constexpr double MeteredElevation = 12.0; // degrees
constexpr double MeteredShare = 0.6;

// Ripples and patches of foam over the wavelength offshore, and the largest, m.
constexpr double RippleShare = 0.06;
constexpr double LongestRipple = 2.5;
constexpr double FoamShare = 0.08;
constexpr double LargestFoam = 4.0;

// Droplets over the height of the waves, and their limits, m; drawn along their way in half the time of a frame of a film.
constexpr double DropletShare = 0.012;
constexpr double SmallestDroplet = 0.004;
constexpr double LargestDroplet = 0.025;
// Wisps of finer ones in the same way.
constexpr double WispShare = 0.13;
constexpr double SmallestWisp = 0.02;
constexpr double LargestWisp = 0.5;
constexpr double Exposure = 1.0 / 48.0; // s

void setUniform(vtkUniforms* uniforms, const char* name, const std::array<double, 3>& value)
{
  const float values[3] = { static_cast<float>(value[0]), static_cast<float>(value[1]), static_cast<float>(value[2]) };
  uniforms->SetUniform3f(name, values);
}

void setUniform(vtkUniforms* uniforms, const char* name, double value)
{
  uniforms->SetUniformf(name, static_cast<float>(value));
}

}

ScenePicture::ScenePicture(const SceneContent& content)
  : Content(content)
  , Shade(content.seafloor, content.sky.sun())
{
  double bounds[6];
  content.seafloor->GetBounds(bounds);
  this->Extent = std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);

  vtkNew<vtkSphereSource> dome;
  const double horizon = std::max(LeastHorizon, ScenesToHorizon * this->Extent);
  dome->SetRadius(1.5 * horizon);
  dome->SetCenter(content.camera.eye[0], content.camera.eye[1], content.camera.eye[2]);
  dome->SetThetaResolution(64);
  dome->SetPhiResolution(64);
  dome->Update();
  const Values onLand{ { "sunSeen", "SunSeen" } };
  const Values onWater{ { "sunSeen", "SunSeen" }, { "foam", "Foam" }, { "bedDepth", "Depth" } };
  const Values ofSpray{ { "dropOpacity", "Opacity" }, { "across", "Across" }, { "along", "Along" },
    { "shade", "Shade" } };
  this->addPart(this->Sky, this->SkyMapper, dome->GetOutput(), {}, skyCode());
  const vtkSmartPointer<vtkPolyData> land = drawing::reliefOf(content.seafloor, this->reliefNodes());
  this->Shade.addTo(land);
  this->addPart(this->Land, this->LandMapper, land, onLand, landCode());
  this->addPart(this->OpenSea, this->OpenSeaMapper, this->openSea(), onWater, waterCode());
  vtkNew<vtkPolyData> none;
  this->addPart(this->Sea, this->SeaMapper, none, onWater, waterCode());
  this->addPart(this->Spray, this->SprayMapper, none, ofSpray, sprayCode());
  this->Spray->ForceTranslucentOn();

  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(content.camera.eye.data());
  camera->SetFocalPoint(content.camera.focus.data());
  camera->SetViewUp(content.camera.up.data());
  camera->SetViewAngle(content.camera.angle);
  const double over = content.camera.eye[2] - content.waterLevel;
  camera->SetClippingRange(std::max(0.2, 0.2 * over), 2.0 * horizon);
  // Light is the shaders' own; without one VTK passes no normals to them.
  this->Renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> light;
  this->Renderer->AddLight(light);

  const int factor = std::max(content.width, content.height) <= LargestOversampled ? Oversampling : 1;
  this->Window->SetOffScreenRendering(1);
  this->Window->SetShowWindow(false);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(content.width * factor, content.height * factor);
  this->Window->AddRenderer(this->Renderer);
}

void ScenePicture::addPart(
  vtkActor* actor, vtkPolyDataMapper* mapper, vtkPolyData* data, const Values& values, const std::string& code)
{
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  // Shaders compute with places in metres.
  if (auto* drawn = vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    drawn->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  }
  std::vector<std::string> names;
  for (const auto& [name, array] : values)
  {
    mapper->MapDataArrayToVertexAttribute(
      (name + "MC").c_str(), array.c_str(), vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
    names.push_back(name);
  }
  actor->SetMapper(mapper);
  vtkShaderProperty* shader = actor->GetShaderProperty();
  shader->AddVertexShaderReplacement(
    "//VTK::Normal::Dec", true, "//VTK::Normal::Dec\n" + vertexDeclarations(names), false);
  shader->AddVertexShaderReplacement("//VTK::Normal::Impl", true, "//VTK::Normal::Impl\n" + vertexCode(names), false);
  shader->AddFragmentShaderReplacement(
    "//VTK::Normal::Dec", true, "//VTK::Normal::Dec\n" + fragmentDeclarations(names) + sharedFunctions(), false);
  shader->AddFragmentShaderReplacement("//VTK::Light::Impl", true, code, false);
  this->setUniforms(actor, 0.0);
  this->Renderer->AddActor(actor);
}

void ScenePicture::setUniforms(vtkActor* actor, double time)
{
  vtkUniforms* uniforms = actor->GetShaderProperty()->GetFragmentCustomUniforms();
  const SkyModel& sky = this->Content.sky;
  const char* names[] = { "perezA", "perezB", "perezC", "perezD", "perezE" };
  for (std::size_t i = 0; i < 5; ++i)
  {
    setUniform(uniforms, names[i], sky.coefficients()[i]);
  }
  setUniform(uniforms, "skyScale", sky.scale());
  setUniform(uniforms, "sunDirection", sky.sun());
  setUniform(uniforms, "middle", this->exposureLuminance());
  setUniform(uniforms, "eye", this->Content.camera.eye);
  setUniform(uniforms, "waterLevel", this->Content.waterLevel);
  setUniform(uniforms, "waveHeight", this->Content.waveHeight);
  setUniform(uniforms, "time", time);
  setUniform(uniforms, "rippleHeading", headingFromNautical(this->Content.directionFrom) + 0.3);
  setUniform(uniforms, "rippleLength", std::min(LongestRipple, RippleShare * this->Content.wavelength));
  setUniform(uniforms, "foamSize", std::min(LargestFoam, FoamShare * this->Content.wavelength));
  setUniform(uniforms, "haze", std::max(Visibility, ScenesVisible * this->Extent));
  double bounds[6];
  this->Content.seafloor->GetBounds(bounds);
  const float sceneBounds[4] = { static_cast<float>(bounds[0]), static_cast<float>(bounds[2]),
    static_cast<float>(bounds[1]), static_cast<float>(bounds[3]) };
  uniforms->SetUniform4f("sceneBounds", sceneBounds);
  const bool open = actor == this->OpenSea.Get();
  const std::array<float, 4> swell = open ? this->swellAt(time) : std::array<float, 4>{ 0.0F, 0.0F, 0.0F, 0.0F };
  uniforms->SetUniform4f("swell", swell.data());
}

double ScenePicture::exposureLuminance() const
{
  const SceneCamera& camera = this->Content.camera;
  const double middle = this->Content.sky.middleLuminance();
  const double x = camera.focus[0] - camera.eye[0];
  const double y = camera.focus[1] - camera.eye[1];
  const double level = std::hypot(x, y);
  if (!(level > 0.0))
  {
    return middle;
  }
  const double along = std::cos(radians(MeteredElevation)) / level;
  const Light seen = this->Content.sky.light({ along * x, along * y, std::sin(radians(MeteredElevation)) });
  const double luminance = 0.2126 * seen[0] + 0.7152 * seen[1] + 0.0722 * seen[2];
  return middle * std::pow(std::max(1.0, luminance / middle), MeteredShare);
}

std::array<float, 4> ScenePicture::swellAt(double time) const
{
  double bounds[6];
  this->Content.seafloor->GetBounds(bounds);
  double range[2];
  this->Content.seafloor->GetPointData()->GetArray("Elevation")->GetFiniteRange(range, 0);
  const double omega = 2.0 * Pi / this->Content.period;
  const double k = solveWavenumber(omega, std::max(1e-3, this->Content.waterLevel - range[0]));
  const double heading = headingFromNautical(this->Content.directionFrom);
  const double x = k * std::cos(heading);
  const double y = k * std::sin(heading);
  // The phase is 0 where the wave first meets the scene.
  const double begin = std::min(x * bounds[0], x * bounds[1]) + std::min(y * bounds[2], y * bounds[3]);
  return { static_cast<float>(x), static_cast<float>(y), static_cast<float>(begin + omega * time),
    static_cast<float>(0.5 * this->Content.waveHeight) };
}

vtkIdType ScenePicture::reliefNodes() const
{
  double bounds[6];
  this->Content.seafloor->GetBounds(bounds);
  double range[2];
  this->Content.seafloor->GetPointData()->GetArray("Elevation")->GetFiniteRange(range, 0);
  const double box[3][2] = { { bounds[0], bounds[1] }, { bounds[2], bounds[3] }, { range[0], range[1] } };
  double square = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double beside = this->Content.camera.eye[i] - std::clamp(this->Content.camera.eye[i], box[i][0], box[i][1]);
    square += beside * beside;
  }
  const double pixel = std::sqrt(square) * radians(this->Content.camera.angle) / this->Content.height;
  const double area = (bounds[1] - bounds[0]) * (bounds[3] - bounds[2]);
  return static_cast<vtkIdType>(
    pixel > 0.0 ? std::clamp(area / (pixel * pixel), LeastReliefNodes, MostReliefNodes) : MostReliefNodes);
}

vtkSmartPointer<vtkPolyData> ScenePicture::openSea() const
{
  vtkNew<vtkDiskSource> disk;
  disk->SetInnerRadius(0.0);
  disk->SetOuterRadius(std::max(LeastHorizon, ScenesToHorizon * this->Extent));
  disk->SetRadialResolution(2);
  disk->SetCircumferentialResolution(96);
  disk->Update();
  auto sea = vtkSmartPointer<vtkPolyData>::New();
  sea->DeepCopy(disk->GetOutput());
  const vtkIdType count = sea->GetNumberOfPoints();
  vtkNew<vtkFloatArray> foam;
  foam->SetName("Foam");
  foam->SetNumberOfTuples(count);
  foam->Fill(0.0);
  vtkNew<vtkFloatArray> seen;
  seen->SetName("SunSeen");
  seen->SetNumberOfTuples(count);
  seen->Fill(1.0);
  vtkNew<vtkDoubleArray> depth;
  depth->SetName("Depth");
  depth->SetNumberOfTuples(count);
  double range[2];
  this->Content.seafloor->GetPointData()->GetArray("Elevation")->GetFiniteRange(range, 0);
  depth->Fill(std::max(0.0, this->Content.waterLevel - range[0]));
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    sea->GetPoint(i, p);
    points->InsertNextPoint(p[0] + this->Content.camera.eye[0], p[1] + this->Content.camera.eye[1],
      this->Content.waterLevel - OpenSeaDepth * this->Content.waveHeight);
    normals->SetTuple3(i, 0.0, 0.0, 1.0);
  }
  sea->SetPoints(points);
  sea->GetPointData()->AddArray(foam);
  sea->GetPointData()->AddArray(seen);
  sea->GetPointData()->AddArray(depth);
  sea->GetPointData()->SetNormals(normals);
  return sea;
}

vtkSmartPointer<vtkImageData> ScenePicture::draw(vtkPolyData* surface, double time, vtkPolyData* spray)
{
  this->Shade.setWaves(surface);
  vtkNew<vtkPolyData> sea;
  sea->ShallowCopy(surface);
  this->Shade.addTo(sea);
  this->SeaMapper->SetInputData(sea);
  if (spray)
  {
    StreakView view;
    view.eye = this->Content.camera.eye;
    view.exposure = Exposure;
    view.radius = std::clamp(DropletShare * this->Content.waveHeight, SmallestDroplet, LargestDroplet);
    view.wisp = std::clamp(WispShare * this->Content.waveHeight, SmallestWisp, LargestWisp);
    view.pixel = radians(this->Content.camera.angle) / this->Content.height;
    this->SprayMapper->SetInputData(streaksOf(spray, view));
  }
  this->Spray->SetVisibility(spray && spray->GetNumberOfPoints() > 0);
  for (vtkActor* actor : { this->Sky.Get(), this->Sea.Get(), this->OpenSea.Get(), this->Land.Get(), this->Spray.Get() })
  {
    this->setUniforms(actor, time);
  }
  this->Window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(this->Window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  const int factor = this->Window->GetSize()[0] / this->Content.width;
  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputConnection(grab->GetOutputPort());
  shrink->SetShrinkFactors(factor, factor, 1);
  shrink->MeanOn();
  shrink->Update();
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->DeepCopy(shrink->GetOutput());
  return picture;
}

}
