#pragma once

#include <gdal_priv.h>

#include <cstddef>
#include <memory>
#include <string>

// What the writers of files by GDAL share.
namespace swellray::gdaloutput
{

/** While it lives, no side-car files: everything is in the one file, or nowhere. */
class NoSideCars
{
public:
  NoSideCars();
  ~NoSideCars();
  NoSideCars(const NoSideCars&) = delete;
  void operator=(const NoSideCars&) = delete;
};

/** @throws std::runtime_error with GDAL's reason unless a step was done and GDAL reported no failure */
void require(bool done);

/** @throws std::runtime_error where this GDAL has none of that name */
GDALDriver* driverNamed(const char* name);

struct CloseDataset
{
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

/**
 * HDF5 does not survive a disk that is full (it crashes when the process ends), so that room is made before.
 * @param values size of the values as they are, bytes
 * @throws std::runtime_error where there is none
 */
void requireRoom(const std::string& path, std::size_t values);

/** A new netCDF-4 file. */
Dataset createNetcdf(const std::string& path);

/** Write what is left and close. */
void close(Dataset& dataset);

/** A text attribute of a group or a variable. */
template <typename Object>
void setText(Object& object, const std::string& name, const std::string& value)
{
  const auto attribute = object.CreateAttribute(name, {}, GDALExtendedDataType::CreateString());
  require(attribute && attribute->Write(value.c_str()));
}

}
