#pragma once

#include "bathymetry/NetcdfArrays.h"
#include "bathymetry/RasterSource.h"

class GDALDataset;
class GDALMDArray;

namespace swellray
{

/**
 * A variable of a NetCDF file on two axes given by one-dimensional coordinate variables, with or without CF
 * attributes, ascending or descending, in either order. Used by openRaster().
 */
class NetcdfRaster final : public RasterSource
{
public:
  NetcdfRaster(const std::string& path, const std::string& variable);
  ~NetcdfRaster() override;

  std::vector<double> read(const RasterWindow& window, double nodata) const override;

private:
  struct Axis;
  struct Candidate;

  std::shared_ptr<GDALMDArray> coordinates(const GDALMDArray& array, std::size_t dimension) const;
  bool findAxes(const GDALMDArray& array, Candidate& candidate) const;
  Axis readAxis(const GDALMDArray& coordinate) const;
  void select(const std::string& variable);
  void readPlace(const Candidate& candidate);
  void readMeaning();

  std::unique_ptr<GDALDataset> Dataset;
  std::vector<NetcdfArray> Arrays;
  std::shared_ptr<GDALMDArray> Array;
  std::size_t XDimension = 0;
  std::size_t YDimension = 0;
};

}
