#include "RasterFile.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <atomic>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include <unistd.h>

namespace swellray::test
{

namespace
{

GDALDriver& driver(const char* name)
{
  GDALAllRegister();
  GDALDriver* found = GetGDALDriverManager()->GetDriverByName(name);
  if (!found)
  {
    throw std::runtime_error(std::string("GDAL has no driver ") + name);
  }
  return *found;
}

void require(bool done, const std::string& what)
{
  if (!done)
  {
    throw std::runtime_error("cannot make test file: " + what + ": " + CPLGetLastErrorMsg());
  }
}

}

Folder::Folder()
{
  static std::atomic<int> number{ 0 };
  const auto path = std::filesystem::temp_directory_path() /
    ("swellray-test-" + std::to_string(::getpid()) + "-" + std::to_string(number++));
  std::filesystem::create_directories(path);
  this->Path = path.string();
}

Folder::~Folder()
{
  std::error_code ignored;
  std::filesystem::remove_all(this->Path, ignored);
}

std::string Folder::file(const std::string& name) const
{
  return this->Path + "/" + name;
}

glm::dvec2 RasterFile::centre(int column, int row) const
{
  const auto& a = this->transform;
  const double c = column + 0.5;
  const double r = row + 0.5;
  return { a[0] + c * a[1] + r * a[2], a[3] + c * a[4] + r * a[5] };
}

void RasterFile::fill(const Bed& bed)
{
  this->values.resize(static_cast<std::size_t>(this->columns) * static_cast<std::size_t>(this->rows));
  for (int row = 0; row < this->rows; ++row)
  {
    for (int column = 0; column < this->columns; ++column)
    {
      this->at(column, row) = bed(this->centre(column, row));
    }
  }
}

void RasterFile::writeGeoTiff(const std::string& path) const
{
  std::unique_ptr<GDALDataset> dataset(
    driver("GTiff").Create(path.c_str(), this->columns, this->rows, this->bands, GDT_Float64, nullptr));
  require(dataset != nullptr, path);
  auto transformCopy = this->transform;
  dataset->SetGeoTransform(transformCopy.data());
  if (!this->crs.empty())
  {
    OGRSpatialReference reference;
    require(reference.SetFromUserInput(this->crs.c_str()) == OGRERR_NONE, this->crs);
    reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    dataset->SetSpatialRef(&reference);
  }
  for (int i = 1; i <= this->bands; ++i)
  {
    GDALRasterBand& band = *dataset->GetRasterBand(i);
    if (this->nodata)
    {
      band.SetNoDataValue(*this->nodata);
    }
    if (this->scale)
    {
      band.SetScale(*this->scale);
    }
    if (this->offset)
    {
      band.SetOffset(*this->offset);
    }
    if (!this->units.empty())
    {
      band.SetUnitType(this->units.c_str());
    }
    for (const auto& [key, value] : this->metadata)
    {
      band.SetMetadataItem(key.c_str(), value.c_str());
    }
    auto copy = this->values;
    require(band.RasterIO(GF_Write, 0, 0, this->columns, this->rows, copy.data(), this->columns, this->rows,
              GDT_Float64, 0, 0, nullptr) == CE_None,
      path);
  }
}

void RasterFile::writeAscii(const std::string& path) const
{
  std::unique_ptr<FILE, int (*)(FILE*)> file(std::fopen(path.c_str(), "w"), &std::fclose);
  require(file != nullptr, path);
  std::fprintf(file.get(), "ncols %d\nnrows %d\nxllcorner %.17g\nyllcorner %.17g\ncellsize %.17g\n", this->columns,
    this->rows, this->transform[0], this->transform[3] + this->rows * this->transform[5], this->transform[1]);
  if (this->nodata)
  {
    std::fprintf(file.get(), "NODATA_value %.17g\n", *this->nodata);
  }
  for (std::size_t i = 0; i < this->values.size(); ++i)
  {
    const bool lastOfRow = (i + 1) % static_cast<std::size_t>(this->columns) == 0;
    std::fprintf(file.get(), "%.9f%s", this->values[i], lastOfRow ? "\n" : " ");
  }
}

void NetcdfFile::write(const std::string& path) const
{
  std::unique_ptr<GDALDataset> dataset(driver("netCDF").CreateMultiDimensional(path.c_str(), nullptr, nullptr));
  require(dataset != nullptr, path);
  const auto root = dataset->GetRootGroup();
  const auto real = GDALExtendedDataType::Create(GDT_Float64);
  const auto dimension = [&](const std::string& name, const std::vector<double>& values, const std::string& unit)
  {
    auto made = root->CreateDimension(name, std::string(), std::string(), values.size());
    auto array = root->CreateMDArray(name, { made }, real);
    require(made && array, name);
    if (!unit.empty())
    {
      array->SetUnit(unit);
    }
    const GUInt64 start = 0;
    const size_t count = values.size();
    require(array->Write(&start, &count, nullptr, nullptr, real, values.data()), name);
    return made;
  };
  const auto yDimension = dimension(this->yName, this->y, this->yUnits);
  const auto xDimension = dimension(this->xName, this->x, this->xUnits);
  for (const std::string& variable : this->variables)
  {
    const auto array = root->CreateMDArray(variable,
      this->xFirst ? std::vector{ xDimension, yDimension } : std::vector{ yDimension, xDimension },
      GDALExtendedDataType::Create(this->packed ? GDT_Int16 : GDT_Float64));
    require(array != nullptr, variable);
    if (!this->units.empty())
    {
      array->SetUnit(this->units);
    }
    if (this->packed)
    {
      array->SetScale(this->scale);
      array->SetOffset(this->offset);
    }
    if (this->nodata)
    {
      array->SetNoDataValue(*this->nodata);
    }
    for (const auto& [key, value] : this->attributes)
    {
      const auto attribute = array->CreateAttribute(key, {}, GDALExtendedDataType::CreateString());
      require(attribute && attribute->Write(value.c_str()), key);
    }
    std::vector<double> values;
    const std::size_t outer = this->xFirst ? this->x.size() : this->y.size();
    const std::size_t inner = this->xFirst ? this->y.size() : this->x.size();
    for (std::size_t i = 0; i < outer; ++i)
    {
      for (std::size_t j = 0; j < inner; ++j)
      {
        const glm::dvec2 place(this->x[this->xFirst ? i : j], this->y[this->xFirst ? j : i]);
        const double z = this->bed(place);
        values.push_back(z == z && this->packed ? (z - this->offset) / this->scale
            : z == z                            ? z
                                                : this->nodata.value_or(Missing));
      }
    }
    const GUInt64 start[] = { 0, 0 };
    const size_t count[] = { outer, inner };
    require(array->Write(start, count, nullptr, nullptr, real, values.data()), variable);
  }
}

std::vector<double> steps(double first, double step, int count)
{
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
  {
    values.push_back(first + i * step);
  }
  return values;
}

}
