#include "SceneView.h"

#include "apps/drawing/ColorMap.h"
#include "apps/drawing/Relief.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkWorldPointPicker.h>

#include <algorithm>
#include <cmath>

namespace swellray::view
{

namespace
{

using drawing::Rgb;

// A graphics driver in software still draws so many quadrilaterals several times a second.
constexpr vtkIdType MostReliefNodes = 160000;

constexpr int SeafloorShades = 1024;
constexpr int RayShades = 256;

// Lines hover over still water by this share of the wave height, above most crests.
constexpr double Hover = 1.0;

const Rgb Haze{ 0.93, 0.95, 0.97 };
const Rgb Air{ 0.70, 0.80, 0.90 };
const Rgb MarkColor{ 0.87, 0.18, 0.12 };
const Rgb Sea{ 0.10, 0.36, 0.47 };

void setColor(vtkLookupTable* table, int i, const Rgb& color, double opacity = 1.0)
{
  table->SetTableValue(i, color[0], color[1], color[2], opacity);
}

}

SceneView::SceneView(vtkImageData* seafloor)
{
  seafloor->GetBounds(this->Bounds);
  double range[2];
  seafloor->GetPointData()->GetArray("Elevation")->GetFiniteRange(range, 0);
  const double width = std::max(this->Bounds[1] - this->Bounds[0], this->Bounds[3] - this->Bounds[2]);
  this->Exaggeration = drawing::exaggerationFor(width, range[1] - range[0]);
  this->Bounds[4] = range[0];
  this->Bounds[5] = range[1];

  this->SeafloorColors->SetNumberOfTableValues(SeafloorShades);
  this->SeafloorColors->SetTableRange(range[0], range[1] > range[0] ? range[1] : range[0] + 1.0);
  this->SeafloorMapper->SetInputData(drawing::reliefOf(seafloor, MostReliefNodes));
  this->SeafloorMapper->SetLookupTable(this->SeafloorColors);
  this->SeafloorMapper->UseLookupTableScalarRangeOn();
  // Colours by elevation within a cell, not between the colours of its corners: the shore stays sharp.
  this->SeafloorMapper->InterpolateScalarsBeforeMappingOn();
  this->Seafloor->SetMapper(this->SeafloorMapper);
  this->Seafloor->GetProperty()->SetSpecular(0.0);
  this->Seafloor->GetProperty()->SetAmbient(0.15);

  this->RayColors->SetNumberOfTableValues(RayShades);
  for (int i = 0; i < RayShades; ++i)
  {
    setColor(this->RayColors, i, drawing::rayMap().rgb(i / (RayShades - 1.0)));
  }
  setColor(this->RayColors, 0, drawing::rayMap().rgb(0.0));
  this->RaysMapper->SetLookupTable(this->RayColors);
  this->RaysMapper->UseLookupTableScalarRangeOn();
  this->RaysMapper->SetScalarModeToUsePointFieldData();
  this->RaysMapper->SelectColorArray("WaveHeight");
  this->Rays->SetMapper(this->RaysMapper);
  this->Rays->GetProperty()->LightingOff();
  this->Rays->GetProperty()->SetLineWidth(1.2F);

  this->CrestsMapper->ScalarVisibilityOff();
  this->Crests->SetMapper(this->CrestsMapper);
  this->Crests->GetProperty()->LightingOff();
  this->Crests->GetProperty()->SetColor(1.0, 1.0, 1.0);
  this->Crests->GetProperty()->SetLineWidth(1.0F);

  constexpr int FoamShades = 64;
  this->SurfaceColors->SetNumberOfTableValues(FoamShades);
  this->SurfaceColors->SetTableRange(0.0, 1.0);
  for (int i = 0; i < FoamShades; ++i)
  {
    const double t = i / (FoamShades - 1.0);
    setColor(this->SurfaceColors, i,
      { Sea[0] + t * (0.97 - Sea[0]), Sea[1] + t * (0.98 - Sea[1]), Sea[2] + t * (0.99 - Sea[2]) }, 0.72 + 0.26 * t);
  }
  this->SurfaceMapper->SetLookupTable(this->SurfaceColors);
  this->SurfaceMapper->UseLookupTableScalarRangeOn();
  this->SurfaceMapper->SetScalarModeToUsePointFieldData();
  this->SurfaceMapper->SelectColorArray("Foam");
  this->SurfaceMapper->InterpolateScalarsBeforeMappingOn();
  this->Surface->SetMapper(this->SurfaceMapper);
  this->Surface->GetProperty()->SetSpecular(0.6);
  this->Surface->GetProperty()->SetSpecularPower(40.0);
  this->Surface->ForceTranslucentOn();

  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.006 * width);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(16);
  vtkNew<vtkPolyDataMapper> ballMapper;
  ballMapper->SetInputConnection(ball->GetOutputPort());
  this->Mark->SetMapper(ballMapper);
  this->Mark->GetProperty()->SetColor(MarkColor[0], MarkColor[1], MarkColor[2]);
  this->Mark->VisibilityOff();
  this->MarkedRayMapper->ScalarVisibilityOff();
  this->MarkedRay->SetMapper(this->MarkedRayMapper);
  this->MarkedRay->GetProperty()->LightingOff();
  this->MarkedRay->GetProperty()->SetColor(MarkColor[0], MarkColor[1], MarkColor[2]);
  this->MarkedRay->GetProperty()->SetLineWidth(4.0F);
  this->MarkedRay->VisibilityOff();

  for (vtkActor* actor : { this->Seafloor.Get(), this->Rays.Get(), this->Crests.Get(), this->Surface.Get(),
         this->MarkedRay.Get(), this->Mark.Get() })
  {
    this->Renderer->AddActor(actor);
  }
  for (vtkActor* actor :
    { this->Seafloor.Get(), this->Rays.Get(), this->Crests.Get(), this->Surface.Get(), this->MarkedRay.Get() })
  {
    actor->SetScale(1.0, 1.0, this->Exaggeration);
  }
  for (vtkActor* actor : { this->Rays.Get(), this->Crests.Get(), this->Surface.Get() })
  {
    actor->SetVisibility(actor != this->Surface);
    actor->PickableOff();
  }
  this->setRays(nullptr, 1.0);
  this->setCrests(nullptr);
  this->setSurface(nullptr);
  this->show(Part::Surface, true);

  this->Renderer->SetBackground(Haze[0], Haze[1], Haze[2]);
  this->Renderer->SetBackground2(Air[0], Air[1], Air[2]);
  this->Renderer->GradientBackgroundOn();
  this->Renderer->AutomaticLightCreationOff();
  // Light from the north-west, as on maps, and a weak one from the eye.
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetPositional(false);
  sun->SetPosition(-1.0, 1.0, 1.4);
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  sun->SetIntensity(0.85);
  vtkNew<vtkLight> eye;
  eye->SetLightTypeToHeadlight();
  eye->SetIntensity(0.3);
  this->Renderer->AddLight(sun);
  this->Renderer->AddLight(eye);
  this->lookAslant();
}

vtkActor* SceneView::actor(Part part) const
{
  switch (part)
  {
  case Part::Seafloor:
    return this->Seafloor;
  case Part::Rays:
    return this->Rays;
  case Part::Crests:
    return this->Crests;
  default:
    return this->Surface;
  }
}

void SceneView::show(Part part, bool on)
{
  this->actor(part)->SetVisibility(on);
}

bool SceneView::isShown(Part part) const
{
  return this->actor(part)->GetVisibility() != 0;
}

void SceneView::setWaterLevel(double level)
{
  this->WaterLevel = level;
  const double* range = this->SeafloorColors->GetTableRange();
  const double deepest = std::max(1e-6, level - range[0]);
  const double highest = std::max(1e-6, range[1] - level);
  for (int i = 0; i < SeafloorShades; ++i)
  {
    const double elevation = range[0] + (i + 0.5) / SeafloorShades * (range[1] - range[0]);
    const double depth = level - elevation;
    setColor(this->SeafloorColors, i,
      depth > 0.0 ? drawing::waterMap().rgb(depth / deepest) : drawing::landMap().rgb(-depth / highest));
  }
  this->SeafloorColors->Modified();
  this->raise();
}

void SceneView::raise()
{
  const double lift = this->Exaggeration * Hover * this->WaveHeight;
  this->Rays->SetPosition(0.0, 0.0, lift);
  this->Crests->SetPosition(0.0, 0.0, lift);
  this->MarkedRay->SetPosition(0.0, 0.0, 1.05 * lift);
}

void SceneView::setRays(vtkPolyData* rays, double height)
{
  vtkNew<vtkPolyData> none;
  this->RaysMapper->SetInputData(rays ? rays : none.Get());
  this->WaveHeight = height;
  this->RayColors->SetTableRange(0.0, 2.0 * height);
  this->raise();
}

void SceneView::setCrests(vtkPolyData* crests)
{
  vtkNew<vtkPolyData> none;
  this->CrestsMapper->SetInputData(crests ? crests : none.Get());
}

void SceneView::setSurface(vtkPolyData* surface)
{
  vtkNew<vtkPolyData> none;
  this->SurfaceMapper->SetInputData(surface ? surface : none.Get());
}

void SceneView::setMark(double x, double y, double z, vtkPolyData* rays, vtkIdType ray)
{
  this->Mark->VisibilityOn();
  // In the height of the lines, which would hide it.
  this->Mark->SetPosition(x, y, this->Exaggeration * (z + Hover * this->WaveHeight));
  this->MarkedRay->SetVisibility(ray >= 0);
  if (ray < 0 || !rays)
  {
    return;
  }
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  rays->GetCellPoints(ray, count, ids);
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(count, ids);
  vtkNew<vtkPolyData> marked;
  marked->SetPoints(rays->GetPoints());
  marked->SetLines(line);
  this->MarkedRayMapper->SetInputData(marked);
}

void SceneView::reset(const double direction[3], const double up[3])
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double center[3] = { 0.5 * (this->Bounds[0] + this->Bounds[1]), 0.5 * (this->Bounds[2] + this->Bounds[3]),
    0.5 * this->Exaggeration * (this->Bounds[4] + this->Bounds[5]) };
  camera->SetFocalPoint(center);
  camera->SetPosition(center[0] + direction[0], center[1] + direction[1], center[2] + direction[2]);
  camera->SetViewUp(up);
  double bounds[6];
  std::copy(this->Bounds, this->Bounds + 6, bounds);
  bounds[4] *= this->Exaggeration;
  bounds[5] *= this->Exaggeration;
  this->Renderer->ResetCamera(bounds);
  // The sphere around the scene leaves much room beside it.
  constexpr double Closer = 1.25;
  camera->Dolly(Closer);
  this->Renderer->ResetCameraClippingRange();
}

void SceneView::lookAslant()
{
  const double direction[3] = { 0.0, -0.8, 0.75 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  this->reset(direction, up);
}

void SceneView::lookDown()
{
  const double direction[3] = { 0.0, 0.0, 1.0 };
  const double up[3] = { 0.0, 1.0, 0.0 };
  this->reset(direction, up);
}

bool SceneView::placeAt(int x, int y, double place[3])
{
  // Water is seen through: the picker tells a place on the seafloor, or far behind where there is none.
  vtkNew<vtkWorldPointPicker> picker;
  picker->Pick(x, y, 0.0, this->Renderer);
  picker->GetPickPosition(place);
  const double level = this->Exaggeration * this->WaterLevel;
  double eye[3];
  this->Renderer->GetActiveCamera()->GetPosition(eye);
  if (place[2] < level && eye[2] > level)
  {
    const double share = (level - eye[2]) / (place[2] - eye[2]);
    for (int i = 0; i < 3; ++i)
    {
      place[i] = eye[i] + share * (place[i] - eye[i]);
    }
  }
  place[2] /= this->Exaggeration;
  return place[0] >= this->Bounds[0] && place[0] <= this->Bounds[1] && place[1] >= this->Bounds[2] &&
    place[1] <= this->Bounds[3];
}

}
