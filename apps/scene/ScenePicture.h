#pragma once

#include "SceneCamera.h"
#include "SkyModel.h"
#include "SunShade.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <string>
#include <utility>
#include <vector>

class vtkImageData;
class vtkPolyData;

namespace swellray::scene
{

/** What a picture of a scene is made of. */
struct SceneContent
{
  vtkImageData* seafloor = nullptr; ///< point array Elevation, m
  double waterLevel = 0.0;          ///< m
  double waveHeight = 1.0;          ///< offshore, m
  double wavelength = 100.0;        ///< offshore, m
  double period = 8.0;              ///< s
  double directionFrom = 270.0;     ///< of the waves, nautical degrees
  SceneCamera camera;
  SkyModel sky{ 250.0, 35.0 };
  int width = 1600; ///< of the picture, pixels
  int height = 900;
};

/**
 * Pictures of sky, sea and shore, drawn off screen by shaders of our own: the sky by SkyModel and its reflection by
 * Fresnel's law (Schlick 1994), ripples of the wind, light through shallow water and thin crests, foam, spray in motion, sand
 * that is wet as high as waves come, shadows of land and waves, and air in between.
 *
 * It needs a display (drawing::VirtualDisplay).
 */
class ScenePicture
{
public:
  explicit ScenePicture(const SceneContent& content);

  /**
   * Draw the sea at a time.
   * @param surface of vtkSwellFoam: point arrays Normals, Foam and Depth
   * @param spray of vtkSwellSpray: point array Velocity; null: none
   * @return red, green, blue, unsigned char, the lower row first
   */
  vtkSmartPointer<vtkImageData> draw(vtkPolyData* surface, double time, vtkPolyData* spray = nullptr);

private:
  // Values of points that shaders read, and the arrays that have them.
  using Values = std::vector<std::pair<std::string, std::string>>;

  void addPart(
    vtkActor* actor, vtkPolyDataMapper* mapper, vtkPolyData* data, const Values& values, const std::string& code);
  void setUniforms(vtkActor* actor, double time);
  double exposureLuminance() const;                // that is shown as a middle tone, kcd/m2
  std::array<float, 4> swellAt(double time) const; // wavenumber vector, phase and amplitude of the incident wave
  vtkSmartPointer<vtkPolyData> openSea() const;
  vtkIdType reliefNodes() const;

  SceneContent Content;
  SunShade Shade;
  double Extent = 1.0; // of the scene, m
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Sky, Sea, OpenSea, Land, Spray;
  vtkNew<vtkPolyDataMapper> SkyMapper, SeaMapper, OpenSeaMapper, LandMapper, SprayMapper;
};

}
