#pragma once

#include "bathymetry/RasterSource.h"

class GDALDataset;
class GDALGroup;
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

  void listArrays(const std::shared_ptr<GDALGroup>& group, const std::string& prefix, int depth);
  std::shared_ptr<GDALMDArray> coordinates(const GDALMDArray& array, std::size_t dimension) const;
  bool findAxes(const GDALMDArray& array, Candidate& candidate) const;
  Axis readAxis(const GDALMDArray& coordinate) const;
  void select(const std::string& variable);
  void readPlace(const Candidate& candidate);
  void readMeaning();

  struct NamedArray
  {
    std::string name;
    std::shared_ptr<GDALMDArray> array;
  };
  std::unique_ptr<GDALDataset> Dataset;
  std::vector<NamedArray> Arrays;
  std::shared_ptr<GDALMDArray> Array;
  std::size_t XDimension = 0;
  std::size_t YDimension = 0;
};

}
