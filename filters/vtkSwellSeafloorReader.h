#ifndef vtkSwellSeafloorReader_h
#define vtkSwellSeafloorReader_h

#include "swellrayFiltersModule.h"
#include "vtkImageAlgorithm.h"

#include <memory> // for what was read

namespace swellray
{
struct SeafloorReport;
}

/**
 * @class   vtkSwellSeafloorReader
 * @brief   read a seafloor, or make a built-in one, as an image of elevations
 *
 * Wraps swellray::readSeafloor and swellray::makeBuiltinSeafloor (what is read, how signs, units, places and gaps are
 * understood: there). FileName is any raster that GDAL reads, the grid of a wave model by the file that names the rest
 * of it, a UGRID mesh, soundings (text or NetCDF), an image file .vti with the point array Elevation, a VTK grid or mesh
 * (.vts, .vtu), or a built-in form `NAME:key=value,...`.
 *
 * Output: vtkImageData, one layer, x east, y north, metres, with
 * - point scalars Elevation (double, m, positive up; NaN: a hole)
 * - field data OriginX, OriginY (file coordinates of the point (0, 0), always), CRS (WKT), OriginLongitude and
 *   OriginLatitude (degrees) where they are known
 * - field data SeafloorForm: the built-in form, where neither resampled nor smoothed. Filters then take its formula;
 *   the image, 500 nodes along the longer side, is there to be looked at.
 * - on the ellipsoid field data EarthModel, the CRS being that of the Mercator map, and the grid in degrees,
 *   GeographicElevation and GeographicGrid: filters then take its spline, and the image is there to be looked at.
 *
 * A file is read once: again only when its name, its date or an option has changed. A failure sets the error code.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellSeafloorReader : public vtkImageAlgorithm
{
public:
  static vtkSwellSeafloorReader* New();
  vtkTypeMacro(vtkSwellSeafloorReader, vtkImageAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PositiveDirections
  {
    AUTO = 0,
    UP = 1,
    DOWN = 2
  };

  enum EarthModels
  {
    PLANE = 0,
    ELLIPSOID = 1
  };

  ///@{
  /** File, or built-in form. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** Still-water level, m, positive up, for the report and to see that there is water; default 0. */
  vtkSetMacro(WaterLevel, double);
  vtkGetMacro(WaterLevel, double);
  ///@}

  ///@{
  /** Which way the file's values count: as the file says, otherwise up (default); elevations; depths. */
  vtkSetClampMacro(Positive, int, AUTO, DOWN);
  vtkGetMacro(Positive, int);
  void SetPositiveToAuto() { this->SetPositive(AUTO); }
  void SetPositiveToUp() { this->SetPositive(UP); }
  void SetPositiveToDown() { this->SetPositive(DOWN); }
  ///@}

  ///@{
  /** CRS in place of the file's own: EPSG:n, WKT or PROJ; "local" for metres without a place; default none. */
  vtkSetStringMacro(CRS);
  vtkGetStringMacro(CRS);
  ///@}

  ///@{
  /** Read only the box Crop; default off. */
  vtkSetMacro(UseCrop, vtkTypeBool);
  vtkGetMacro(UseCrop, vtkTypeBool);
  vtkBooleanMacro(UseCrop, vtkTypeBool);
  ///@}

  ///@{
  /** x0, y0, x1, y1 in the file's own coordinates; x0 < x1, y0 < y1. */
  vtkSetVector4Macro(Crop, double);
  vtkGetVector4Macro(Crop, double);
  ///@}

  ///@{
  /**
   * On what Earth a grid in longitude and latitude is seen: a plane map (default), or the ellipsoid of its CRS. Then the
   * image is on Mercator's map, and rays are traced over the grid itself.
   */
  vtkSetClampMacro(Earth, int, PLANE, ELLIPSOID);
  vtkGetMacro(Earth, int);
  void SetEarthToPlane() { this->SetEarth(PLANE); }
  void SetEarthToEllipsoid() { this->SetEarth(ELLIPSOID); }
  ///@}

  ///@{
  /** Node distance of the image, m; default 0: the file's own, or about the mean distance of soundings. */
  vtkSetMacro(Resample, double);
  vtkGetMacro(Resample, double);
  ///@}

  ///@{
  /** Standard deviation of the Gaussian that smooths the elevations, m; >= 0, default 0: none. */
  vtkSetMacro(Smooth, double);
  vtkGetMacro(Smooth, double);
  ///@}

  ///@{
  /** Take NoData for no data, beside the file's own value; default off. */
  vtkSetMacro(UseNoData, vtkTypeBool);
  vtkGetMacro(UseNoData, vtkTypeBool);
  vtkBooleanMacro(UseNoData, vtkTypeBool);
  ///@}

  ///@{
  /** Value, as stored in the file, that stands for no data. */
  vtkSetMacro(NoData, double);
  vtkGetMacro(NoData, double);
  ///@}

  ///@{
  /**
   * Widest gap at the border of the grid that is filled, m; default -1: 5 cells. Soundings: distance from all of them
   * beyond which there is a hole; -1: from their density.
   */
  vtkSetMacro(MaxGap, double);
  vtkGetMacro(MaxGap, double);
  ///@}

  ///@{
  /** Variable of a NetCDF file, or number or description of a raster band; default: the only one that can be meant. */
  vtkSetStringMacro(Variable);
  vtkGetStringMacro(Variable);
  ///@}

  ///@{
  /** Soundings: leave out those far off their natural neighbours; default off. */
  vtkSetMacro(DropOutliers, vtkTypeBool);
  vtkGetMacro(DropOutliers, vtkTypeBool);
  vtkBooleanMacro(DropOutliers, vtkTypeBool);
  ///@}

  ///@{
  /** Soundings: measure the error by leaving out a tenth of them at a time, for the report; default off. */
  vtkSetMacro(CrossValidate, vtkTypeBool);
  vtkGetMacro(CrossValidate, vtkTypeBool);
  vtkBooleanMacro(CrossValidate, vtkTypeBool);
  ///@}

#ifndef __VTK_WRAP__
  /** What was read and how it was understood; null before a successful update. */
  const swellray::SeafloorReport* GetReport() const;
#endif

  ///@{
  /** The report as lines of label and text, in the order in which they are to be printed. */
  int GetNumberOfReportLines() const;
  std::string GetReportLabel(int line) const;
  std::string GetReportText(int line) const;
  ///@}

protected:
  vtkSwellSeafloorReader();
  ~vtkSwellSeafloorReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  char* FileName = nullptr;
  double WaterLevel = 0.0;
  int Positive = AUTO;
  int Earth = PLANE;
  char* CRS = nullptr;
  vtkTypeBool UseCrop = 0;
  double Crop[4] = { 0.0, 0.0, 0.0, 0.0 };
  double Resample = 0.0;
  double Smooth = 0.0;
  vtkTypeBool UseNoData = 0;
  double NoData = 0.0;
  double MaxGap = -1.0;
  vtkTypeBool DropOutliers = 0;
  vtkTypeBool CrossValidate = 0;
  char* Variable = nullptr;

private:
  vtkSwellSeafloorReader(const vtkSwellSeafloorReader&) = delete;
  void operator=(const vtkSwellSeafloorReader&) = delete;

  bool Load();

  struct Reading;
  std::unique_ptr<Reading> Kept;
};

#endif
