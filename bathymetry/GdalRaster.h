#pragma once

#include "bathymetry/RasterSource.h"

class GDALDataset;
class GDALRasterBand;

namespace swellray
{

/** A band of any raster that GDAL opens and places by an affine transform. Used by openRaster(). */
class GdalRaster final : public RasterSource
{
public:
  GdalRaster(const std::string& path, const std::string& variable);
  ~GdalRaster() override;

  std::vector<double> read(const RasterWindow& window, double nodata) const override;
  bool useOverview(double factor) override;

private:
  void selectBand(const std::string& variable);
  void readPlace();
  void readMeaning();

  std::unique_ptr<GDALDataset> Dataset;
  GDALRasterBand* Band = nullptr;   // what its values mean
  GDALRasterBand* Pixels = nullptr; // its values: itself or one of its overviews
};

}
