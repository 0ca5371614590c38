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

/** The unit of a variable, empty where it has none. */
std::string unitOf(const GDALMDArray& array);

/** True for real numbers. */
bool isNumeric(const GDALMDArray& array);

/** True for units of degrees. */
bool isDegrees(const std::string& units);

/** 'x' or 'y' for a coordinate variable, by CF attributes (CF 1.8, sections 4.1, 4.2 and 4.4), then by the usual names; 0. */
char axisLetter(const GDALMDArray& coordinate);

/**
 * All values of a variable, in the order of its dimensions: scaled, and NaN where missing (maskAndScale()).
 * @throws std::runtime_error naming it where it cannot be read, has no values or more than MostNodes
 */
std::vector<double> readAll(const GDALMDArray& array);

/** The same as they are stored. */
std::vector<double> readStored(const GDALMDArray& array);

/**
 * Values as stored become values: scale and offset applied, those marked as missing or out of the valid range NaN.
 * @param nodata further value, as stored, that stands for no data; NaN: none
 */
void maskAndScale(const GDALMDArray& array, double nodata, std::vector<double>& values);

}
