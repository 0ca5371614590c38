#ifndef vtkSwellPlaces_h
#define vtkSwellPlaces_h

#include "swellrayFiltersModule.h"
#include "vtkPointSetAlgorithm.h"

/**
 * @class   vtkSwellPlaces
 * @brief   points from the coordinates of a seafloor's file to its scene, and back
 *
 * Wraps swellray::Georeference (maps and their accuracy there). A scene is metres, x east and y north; file coordinates
 * are longitude and latitude in degrees where the CRS is geographic, otherwise x and y in the file's own unit.
 *
 * Input 0: vtkPointSet, points with x and y in the one; their z is kept.
 * Input 1: vtkDataObject, anything with the georeference of the scene as field data: a seafloor, rays, a map.
 *
 * Output: input 0 with its points in the other, in double precision, and with the georeference of input 1 (field data
 * CRS, OriginX, OriginY, OriginLongitude, OriginLatitude) where they are in the scene.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellPlaces : public vtkPointSetAlgorithm
{
public:
  static vtkSwellPlaces* New();
  vtkTypeMacro(vtkSwellPlaces, vtkPointSetAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Ways
  {
    FILE_TO_SCENE = 0,
    SCENE_TO_FILE = 1
  };

  ///@{
  /** From file coordinates to the scene (default), or back. */
  vtkSetClampMacro(Way, int, FILE_TO_SCENE, SCENE_TO_FILE);
  vtkGetMacro(Way, int);
  void SetWayToScene() { this->SetWay(FILE_TO_SCENE); }
  void SetWayToFile() { this->SetWay(SCENE_TO_FILE); }
  ///@}

  /** Connect what has the georeference. */
  void SetSceneConnection(vtkAlgorithmOutput* scene) { this->SetInputConnection(1, scene); }

protected:
  vtkSwellPlaces();
  ~vtkSwellPlaces() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Way = FILE_TO_SCENE;

private:
  vtkSwellPlaces(const vtkSwellPlaces&) = delete;
  void operator=(const vtkSwellPlaces&) = delete;
};

#endif
