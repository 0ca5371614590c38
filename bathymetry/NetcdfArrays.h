#pragma once

#include <memory>
#include <string>
#include <vector>

class GDALGroup;
class GDALMDArray;

namespace swellray
{

/** A variable of a NetCDF file, its name with those of the groups it is in. */
struct NetcdfArray
{
  std::string name;
  std::shared_ptr<GDALMDArray> array;
};

/** All variables of a group and of those within it. */
std::vector<NetcdfArray> listArrays(GDALGroup& root);

/** An attribute as text, empty where there is none. */
std::string attribute(const GDALMDArray& array, const char* name);

/** An attribute as numbers, none where it is no number. */
std::vector<double> numbers(const GDALMDArray& array, const char* name);

/** True for real numbers. */
bool isNumeric(const GDALMDArray& array);

/** True for units of degrees. */
bool isDegrees(const std::string& units);

/** 'x' or 'y' for a coordinate variable, by CF attributes (CF 1.8, sections 4.1, 4.2 and 4.4), then by the usual names; 0. */
char axisLetter(const GDALMDArray& coordinate);

/**
 * Values as stored become values: scale and offset applied, those marked as missing or out of the valid range NaN.
 * @param nodata further value, as stored, that stands for no data; NaN: none
 */
void maskAndScale(const GDALMDArray& array, double nodata, std::vector<double>& values);

}
