#pragma once

#include <vtkActor.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

class vtkImageData;
class vtkPolyData;

namespace swellray::view
{

/** What is seen in the view: seafloor, rays, crests, sea surface and the place that was clicked. */
class SceneView
{
public:
  /** @param seafloor point array Elevation, m */
  explicit SceneView(vtkImageData* seafloor);

  vtkRenderer* renderer() const { return this->Renderer; }
  double exaggeration() const { return this->Exaggeration; }

  /** Colours of water and land, and the heights of lines, follow the water level, m. */
  void setWaterLevel(double level);

  /**
   * Rays coloured by their heights; null: none.
   * @param height offshore, m: the scale of colours goes to twice that
   */
  void setRays(vtkPolyData* rays, double height);
  void setCrests(vtkPolyData* crests);

  /** Sea surface with point array Foam; null: none. */
  void setSurface(vtkPolyData* surface);

  /** The place that was clicked, m, and the cell of `rays` that came there, -1: none. */
  void setMark(double x, double y, double z, vtkPolyData* rays, vtkIdType ray);

  enum class Part
  {
    Seafloor,
    Rays,
    Crests,
    Surface,
  };
  void show(Part part, bool on);
  bool isShown(Part part) const;

  /** Look from the south at an angle, or straight down. */
  void lookAslant();
  void lookDown();

  /** Place under a pixel, m: on land, or where the view meets still water. @return false where there is none */
  bool placeAt(int x, int y, double place[3]);

private:
  vtkActor* actor(Part part) const;
  void raise();
  void reset(const double direction[3], const double up[3]);

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Seafloor, Rays, Crests, Surface, Mark, MarkedRay;
  vtkNew<vtkPolyDataMapper> SeafloorMapper, RaysMapper, CrestsMapper, SurfaceMapper, MarkedRayMapper;
  vtkNew<vtkLookupTable> SeafloorColors, RayColors, SurfaceColors;
  double Bounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  double Exaggeration = 1.0;
  double WaterLevel = 0.0;
  double WaveHeight = 1.0;
};

}
