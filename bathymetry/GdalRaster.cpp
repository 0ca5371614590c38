#include "bathymetry/GdalRaster.h"

#include "bathymetry/QuietGdal.h"
#include "bathymetry/Text.h"
#include "bathymetry/Wkt.h"

#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace swellray
{

namespace
{

std::string item(GDALMajorObject& object, const char* name)
{
  const char* value = object.GetMetadataItem(name);
  return value ? value : "";
}

}

GdalRaster::GdalRaster(const std::string& path, const std::string& variable)
{
  this->Dataset.reset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
  if (!this->Dataset)
  {
    throw std::runtime_error("not a raster that GDAL can read: " + QuietGdal::lastError("no reason given"));
  }
  this->Header.driver = GDALGetDriverShortName(this->Dataset->GetDriver());
  this->selectBand(variable);
  this->readPlace();
  this->readMeaning();
}

GdalRaster::~GdalRaster()
{
  const QuietGdal quiet;
  this->Dataset.reset();
}

void GdalRaster::selectBand(const std::string& variable)
{
  const int count = this->Dataset->GetRasterCount();
  std::string names;
  int chosen = 0;
  int data = 0;
  for (int i = 1; i <= count; ++i)
  {
    GDALRasterBand& band = *this->Dataset->GetRasterBand(i);
    const std::string description = band.GetDescription();
    const bool asked = !variable.empty() &&
      (variable == std::to_string(i) || variable == description || variable == item(band, "standard_name"));
    const bool known =
      variable.empty() && (plain(description) == "elevation" || isElevationName(item(band, "standard_name")));
    if (chosen == 0 && (asked || known))
    {
      chosen = i;
    }
    data += band.GetColorInterpretation() == GCI_AlphaBand ? 0 : 1;
    names += (i > 1 ? ", " : "") + std::to_string(i) + (description.empty() ? "" : " (" + description + ")");
  }
  if (count == 0)
  {
    throw std::runtime_error("it holds no raster band");
  }
  if (chosen == 0 && variable.empty() && data <= 1)
  {
    chosen = 1;
  }
  if (chosen == 0)
  {
    throw std::runtime_error(variable.empty() ? "it has several bands; choose one with --variable: " + names
                                              : "it has no band '" + variable + "'; there are: " + names);
  }
  this->Band = this->Dataset->GetRasterBand(chosen);
  this->Pixels = this->Band;
  this->Header.variable = this->Band->GetDescription();
  if (this->Header.variable.empty())
  {
    this->Header.variable = item(*this->Band, "NETCDF_VARNAME");
  }
  if (this->Header.variable.empty())
  {
    this->Header.variable = "band " + std::to_string(chosen);
  }
}

void GdalRaster::readPlace()
{
  RasterHeader& header = this->Header;
  // With what lies beside it: a .prj, a .aux.xml, overviews.
  char** const files = this->Dataset->GetFileList();
  for (char** file = files; file && *file; ++file)
  {
    header.files.emplace_back(*file);
  }
  CSLDestroy(files);
  header.columns = static_cast<std::size_t>(this->Dataset->GetRasterXSize());
  header.rows = static_cast<std::size_t>(this->Dataset->GetRasterYSize());
  double a[6];
  if (this->Dataset->GetGeoTransform(a) == CE_None)
  {
    header.first = glm::dvec2(a[0] + 0.5 * (a[1] + a[2]), a[3] + 0.5 * (a[4] + a[5]));
    header.columnStep = glm::dvec2(a[1], a[4]);
    header.rowStep = glm::dvec2(a[2], a[5]);
  }
  else if (this->Dataset->GetGCPCount() > 0 || this->Dataset->GetMetadata("GEOLOCATION"))
  {
    throw std::runtime_error("it is placed by control points, not by a regular grid; bring it to one first (gdalwarp)");
  }
  else
  {
    header.first = glm::dvec2(0.0, static_cast<double>(header.rows) - 1.0);
    header.columnStep = glm::dvec2(1.0, 0.0);
    header.rowStep = glm::dvec2(0.0, -1.0);
    header.notes.push_back("the file does not say where its cells lie: taken 1 unit apart, first row in the north");
  }
  if (const OGRSpatialReference* crs = this->Dataset->GetSpatialRef())
  {
    header.crs = wktOf(*crs);
    OGRAxisOrientation direction = OAO_Other;
    if (crs->GetAxis("VERT_CS", 0, &direction) && (direction == OAO_Up || direction == OAO_Down))
    {
      header.vertical.rule = direction == OAO_Up ? "up" : "down";
      header.vertical.ruleSource = "vertical CRS";
    }
  }
}

void GdalRaster::readMeaning()
{
  VerticalMetadata& vertical = this->Header.vertical;
  vertical.positive = item(*this->Band, "positive");
  vertical.standardName = item(*this->Band, "standard_name");
  vertical.units = this->Band->GetUnitType();
  if (vertical.units.empty())
  {
    vertical.units = item(*this->Band, "units");
  }
  if (this->Header.driver == "BAG" && vertical.rule.empty())
  {
    vertical.rule = "up";
    vertical.ruleSource = "BAG format";
  }
}

bool GdalRaster::useOverview(double factor)
{
  const QuietGdal quiet;
  RasterHeader& header = this->Header;
  GDALRasterBand* best = nullptr;
  glm::dvec2 ratio(1.0);
  for (int i = 0; i < this->Band->GetOverviewCount(); ++i)
  {
    GDALRasterBand* const overview = this->Band->GetOverview(i);
    if (!overview || overview->GetXSize() < 1 || overview->GetYSize() < 1)
    {
      continue;
    }
    const glm::dvec2 own(static_cast<double>(this->Band->GetXSize()) / overview->GetXSize(),
      static_cast<double>(this->Band->GetYSize()) / overview->GetYSize());
    if (std::max(own.x, own.y) <= factor && own.x > ratio.x)
    {
      best = overview;
      ratio = own;
    }
  }
  if (!best)
  {
    return false;
  }
  const glm::dvec2 corner = header.first - 0.5 * (header.columnStep + header.rowStep);
  header.columns = static_cast<std::size_t>(best->GetXSize());
  header.rows = static_cast<std::size_t>(best->GetYSize());
  header.columnStep *= ratio.x;
  header.rowStep *= ratio.y;
  header.first = corner + 0.5 * (header.columnStep + header.rowStep);
  header.notes.push_back("read from its overview of 1:" + text(ratio.x, 3));
  this->Pixels = best;
  return true;
}

std::vector<double> GdalRaster::read(const RasterWindow& window, double nodata) const
{
  const QuietGdal quiet;
  const int x = static_cast<int>(window.firstColumn);
  const int y = static_cast<int>(window.firstRow);
  const int columns = static_cast<int>(window.columns);
  const int rows = static_cast<int>(window.rows);
  std::vector<double> values(window.columns * window.rows);
  const CPLErr done =
    this->Pixels->RasterIO(GF_Read, x, y, columns, rows, values.data(), columns, rows, GDT_Float64, 0, 0, nullptr);
  if (done != CE_None || QuietGdal::failed())
  {
    throw std::runtime_error("its values cannot be read: " + QuietGdal::lastError("no reason given"));
  }

  const bool single = this->Band->GetRasterDataType() == GDT_Float32;
  NoDataMark missing;
  int has = 0;
  const double mark = this->Band->GetNoDataValue(&has);
  if (has)
  {
    missing.add(mark, single);
  }
  missing.add(nodata, single);
  int hasScale = 0;
  int hasOffset = 0;
  const double scale = this->Band->GetScale(&hasScale);
  const double offset = this->Band->GetOffset(&hasOffset);
  for (double& value : values)
  {
    value = missing(value) ? std::numeric_limits<double>::quiet_NaN()
                           : value * (hasScale ? scale : 1.0) + (hasOffset ? offset : 0.0);
  }

  const int flags = this->Pixels->GetMaskFlags();
  if ((flags & GMF_PER_DATASET) && !(flags & GMF_ALPHA))
  {
    std::vector<unsigned char> mask(values.size());
    if (this->Pixels->GetMaskBand()->RasterIO(
          GF_Read, x, y, columns, rows, mask.data(), columns, rows, GDT_Byte, 0, 0, nullptr) != CE_None)
    {
      throw std::runtime_error("its mask cannot be read: " + QuietGdal::lastError("no reason given"));
    }
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = mask[i] ? values[i] : std::numeric_limits<double>::quiet_NaN();
    }
  }
  return values;
}

}
