#ifndef vtkSwellFoamMap_h
#define vtkSwellFoamMap_h

#include "swellrayFiltersModule.h"
#include "vtkImageData.h"
#include "vtkSwellSurfaceAlgorithm.h"

#include <memory> // for what is kept between frames

namespace swellray
{
class StillFoam;
}

/**
 * @class   vtkSwellFoamMap
 * @brief   foam on a regular grid of still water, at a time
 *
 * Wraps swellray::StillFoam (where it is defined): the foam of vtkSwellFoam where it floats, as a texture seen from above.
 *
 * Inputs, field data and times: vtkSwellSurfaceAlgorithm. Of several waves the most foam counts.
 *
 * Output: vtkImageData, one layer, with the point array
 * - Foam (double): 0 none to 1 where a wave breaks now, NaN where no wave comes; the scalars
 */
class SWELLRAYFILTERS_EXPORT vtkSwellFoamMap : public vtkSwellSurfaceAlgorithm
{
public:
  static vtkSwellFoamMap* New();
  vtkTypeMacro(vtkSwellFoamMap, vtkSwellSurfaceAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The frame. */
  vtkImageData* GetOutput() { return vtkImageData::SafeDownCast(this->GetOutputDataObject(0)); }

  ///@{
  /** Distance of the nodes, m; >= 0, default 0: the nodes of the seafloor. */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /** Time until foam is gone, s, > 0; default 8. */
  vtkSetMacro(FoamLife, double);
  vtkGetMacro(FoamLife, double);
  ///@}

protected:
  vtkSwellFoamMap();
  ~vtkSwellFoamMap() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void MakeFrame(const swellray::SurfaceFrame&, vtkInformationVector**, vtkInformationVector*) override;

  double Spacing = 0.0;
  double FoamLife = 8.0;

private:
  vtkSwellFoamMap(const vtkSwellFoamMap&) = delete;
  void operator=(const vtkSwellFoamMap&) = delete;

  std::unique_ptr<const swellray::StillFoam> Nodes;
  std::size_t NodesOf = 0;                              // the version of the waves that they are of
  double NodesAt[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 }; // and their grid
};

#endif
