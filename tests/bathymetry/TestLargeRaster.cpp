#include "SeafloorChecks.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <memory>
#include <vector>

#include <sys/resource.h>

using namespace swellray;
using namespace swellray::test;
using testing::HasSubstr;

namespace
{

constexpr int Side = 20000;       // cells
constexpr double Cell = 10.0;     // m
constexpr int First = 9000;       // of the cells with data, columns and rows
constexpr int Count = 1200;       // of these
constexpr long MostMemory = 1000; // MB; the whole raster is 3,200 MB of doubles

double plane(const glm::dvec2& p)
{
  return -50.0 + 1e-4 * p.x - 2e-4 * p.y;
}

std::unique_ptr<GDALDataset> create(const std::string& path, int columns, int rows, GDALDataType type)
{
  GDALAllRegister();
  char* options[] = { const_cast<char*>("TILED=YES"), const_cast<char*>("SPARSE_OK=TRUE"),
    const_cast<char*>("COMPRESS=DEFLATE"), nullptr };
  std::unique_ptr<GDALDataset> dataset(
    GetGDALDriverManager()->GetDriverByName("GTiff")->Create(path.c_str(), columns, rows, 1, type, options));
  double transform[] = { 0.0, Cell, 0.0, Cell * rows, 0.0, -Cell };
  dataset->SetGeoTransform(transform);
  return dataset;
}

// The plane at a block of cells from (column, row) on.
void fill(GDALDataset& dataset, int column, int row, int columns, int rows)
{
  std::vector<double> values;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      values.push_back(plane({ Cell * (column + i + 0.5), Cell * (dataset.GetRasterYSize() - row - j - 0.5) }));
    }
  }
  ASSERT_EQ(dataset.GetRasterBand(1)->RasterIO(
              GF_Write, column, row, columns, rows, values.data(), columns, rows, GDT_Float64, 0, 0, nullptr),
    CE_None);
}

// Peak of this process so far, MB.
long peakMemory()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

class LargeRasterTest : public SeafloorFileTest
{
protected:
  std::string makeSparse()
  {
    const std::string path = this->Files.file("sparse.tif");
    const auto dataset = create(path, Side, Side, GDT_Float64);
    dataset->GetRasterBand(1)->SetNoDataValue(-32768.0);
    fill(*dataset, First, First, Count, Count);
    return path;
  }
};

TEST_F(LargeRasterTest, CropTakesTheMemoryOfWhatIsRead)
{
  const std::string path = this->makeSparse();
  SeafloorOptions crop;
  crop.crs = "local";
  const double low = Cell * (First + 100);
  const double south = Cell * (Side - First - 1100);
  crop.crop = { low, south, low + 1000.0 * Cell, south + 1000.0 * Cell };
  // A process of its own, so that what other tests took does not count.
  const auto readAndMeasure = [&]
  {
    const Bathymetry read = readSeafloor(path, crop);
    const bool right = read.grid.columns == 1000 && read.grid.rows == 1000 && largestError(read, plane) < Exact;
    std::_Exit(right && peakMemory() < MostMemory ? 0 : 1);
  };
  EXPECT_EXIT(readAndMeasure(), testing::ExitedWithCode(0), "");
  EXPECT_THAT(errorOf(path), HasSubstr("20000 x 20000 cells, above the limit of 100 million"));
}

TEST_F(LargeRasterTest, ResampleReadsAveragesInStrips)
{
  const std::string path = this->makeSparse();
  SeafloorOptions coarse;
  coarse.crs = "local";
  coarse.resample = 50.0 * Cell;
  // A fifth of the raster, for the time that it takes; above the limit of nodes by itself.
  coarse.crop = { 0.0, Cell * (Side - First - Count - 2000), Cell * Side, Cell * (Side - First + 2850) };
  const auto readAndMeasure = [&]
  {
    const Bathymetry read = readSeafloor(path, coarse);
    const bool right = read.grid.columns == 400 && read.grid.rows > 110 && largestError(read, plane) < Exact &&
      read.report.noDataShare > 0.5 && notesOf(read).find("averaged over 50 x 50") != std::string::npos;
    std::_Exit(right && peakMemory() < MostMemory ? 0 : 1);
  };
  EXPECT_EXIT(readAndMeasure(), testing::ExitedWithCode(0), "");
}

TEST_F(LargeRasterTest, AveragesLeaveOutCellsWithoutData)
{
  const std::string path = this->Files.file("gaps.tif");
  {
    const auto dataset = create(path, 64, 48, GDT_Float64);
    fill(*dataset, 0, 0, 64, 48);
    // One cell of a block of 4 x 4, and another block whole.
    double none[16];
    std::fill(none, none + 16, Missing);
    GDALRasterBand* band = dataset->GetRasterBand(1);
    ASSERT_EQ(band->RasterIO(GF_Write, 8, 8, 1, 1, none, 1, 1, GDT_Float64, 0, 0, nullptr), CE_None);
    ASSERT_EQ(band->RasterIO(GF_Write, 60, 44, 4, 4, none, 4, 4, GDT_Float64, 0, 0, nullptr), CE_None);
  }
  SeafloorOptions coarse;
  coarse.crs = "local";
  coarse.resample = 4.0 * Cell;
  coarse.maxGap = 0.0;
  const Bathymetry read = readSeafloor(path, coarse);
  ASSERT_EQ(read.grid.columns, 16U);
  ASSERT_EQ(read.grid.rows, 12U);
  EXPECT_EQ(read.report.noDataRead, 1U);
  EXPECT_TRUE(std::isnan(read.grid.at(15, 0)));
  // 15 of 16 cells of the block: their mean lies a tenth of a cell off, on a slope of 2e-4.
  EXPECT_LT(largestError(read, plane), 0.2 * Cell * 3e-4);
  EXPECT_GT(largestError(read, plane), Exact);

  // Less than twice the cells: nothing is averaged.
  coarse.resample = 1.9 * Cell;
  EXPECT_THAT(notesOf(readSeafloor(path, coarse)), testing::Not(HasSubstr("averaged")));
}

TEST_F(LargeRasterTest, AMarkThatTheFileDoesNotDeclareIsNotAveragedAway)
{
  const std::string path = this->Files.file("mark.tif");
  {
    const auto dataset = create(path, 64, 48, GDT_Float64);
    fill(*dataset, 0, 0, 64, 48);
    double mark = -32768.0;
    ASSERT_EQ(
      dataset->GetRasterBand(1)->RasterIO(GF_Write, 9, 9, 1, 1, &mark, 1, 1, GDT_Float64, 0, 0, nullptr), CE_None);
  }
  SeafloorOptions coarse;
  coarse.crs = "local";
  coarse.resample = 4.0 * Cell;
  EXPECT_THAT(errorOf(path, coarse), HasSubstr("say --nodata -32768"));
  coarse.nodata = -32768.0;
  EXPECT_LT(largestError(readSeafloor(path, coarse), plane), 0.2 * Cell * 3e-4);
}

TEST_F(LargeRasterTest, OverviewsAreReadWhereTheyAreFineEnough)
{
  const std::string path = this->Files.file("overviews.tif");
  {
    const auto dataset = create(path, 640, 480, GDT_Float64);
    fill(*dataset, 0, 0, 640, 480);
    int levels[] = { 2, 4, 16 };
    ASSERT_EQ(dataset->BuildOverviews("AVERAGE", 3, levels, 0, nullptr, nullptr, nullptr), CE_None);
  }
  SeafloorOptions coarse;
  coarse.crs = "local";
  coarse.resample = 8.0 * Cell;
  const Bathymetry read = readSeafloor(path, coarse);
  EXPECT_THAT(notesOf(read), HasSubstr("read from its overview of 1:4"));
  EXPECT_THAT(notesOf(read), HasSubstr("averaged over 2 x 2"));
  EXPECT_EQ(read.report.fileColumns, 640U);
  EXPECT_EQ(read.grid.columns, 80U);
  // GDAL computes its averages in single precision.
  constexpr double SinglePrecision = 1e-5;
  EXPECT_LT(largestError(read, plane), SinglePrecision);
}

}
