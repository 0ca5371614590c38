#include "bathymetry/GridSoundings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

namespace
{

using namespace swellray;

// Areas of Voronoi cells are differences of products of coordinates: some thousand roundings of 1e-16 of 10 m.
constexpr double ExactElevation = 1e-9;

double plane(const glm::dvec2& p)
{
  return -5.0 - 0.01 * p.x + 0.02 * p.y;
}

// Waves of 250 and 160 m, 2 m high: bent everywhere.
double wavy(const glm::dvec2& p)
{
  return -10.0 + std::sin(p.x / 40.0) * std::cos(p.y / 25.0);
}

Soundings scatter(
  std::size_t count, const glm::dvec2& size, const std::function<double(const glm::dvec2&)>& bed, unsigned seed = 1)
{
  std::mt19937 chance(seed);
  const auto draw = [&chance] { return static_cast<double>(chance()) / 4294967296.0; };
  Soundings soundings;
  soundings.driver = "test";
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = size.x * draw();
    const glm::dvec2 p(x, size.y * draw());
    soundings.add(p.x, p.y, bed(p));
  }
  return soundings;
}

SeafloorOptions local(double spacing)
{
  SeafloorOptions options;
  options.crs = "local";
  options.resample = spacing;
  return options;
}

struct Error
{
  double rms = 0.0;
  double largest = 0.0;
  std::size_t count = 0;
};

// Of the nodes at least `rim` m within the square of the soundings.
Error errorOf(
  const GriddedSoundings& result, const std::function<double(const glm::dvec2&)>& bed, double size, double rim)
{
  Error error;
  for (std::size_t row = 0; row < result.grid.rows; ++row)
  {
    for (std::size_t column = 0; column < result.grid.columns; ++column)
    {
      const glm::dvec2 file = result.georeference.toFile(result.grid.node(column, row));
      const double z = result.grid.at(column, row);
      if (std::isnan(z) || file.x < rim || file.y < rim || file.x > size - rim || file.y > size - rim)
      {
        continue;
      }
      const double off = std::abs(z - bed(file));
      error.rms += off * off;
      error.largest = std::max(error.largest, off);
      ++error.count;
    }
  }
  error.rms = std::sqrt(error.rms / static_cast<double>(error.count));
  return error;
}

TEST(GridSoundings, ReproducesAPlane)
{
  const GriddedSoundings result = gridSoundings(scatter(2000, { 1000.0, 1000.0 }, plane), local(20.0));
  const Error error = errorOf(result, plane, 1000.0, 0.0);
  EXPECT_GT(error.count, 2200U);
  EXPECT_LT(error.largest, ExactElevation);
  EXPECT_LT(result.report.single.largest, ExactElevation);
  EXPECT_EQ(result.report.outliers, 0U);
}

TEST(GridSoundings, MeetsEverySoundingOfALattice)
{
  Soundings soundings;
  for (int row = 0; row < 12; ++row)
  {
    for (int column = 0; column < 15; ++column)
    {
      const glm::dvec2 p(500000.0 + 30.0 * column, 6000000.0 + 30.0 * row);
      soundings.add(p.x, p.y, wavy(p));
    }
  }
  SeafloorOptions options = local(30.0);
  const GriddedSoundings result = gridSoundings(soundings, options);
  ASSERT_EQ(result.grid.columns, 15U);
  ASSERT_EQ(result.grid.rows, 12U);
  EXPECT_EQ(result.georeference.originX(), 500000.0);
  EXPECT_EQ(result.georeference.originY(), 6000000.0);
  for (std::size_t i = 0; i < soundings.size(); ++i)
  {
    EXPECT_EQ(result.grid.elevation[i], soundings.z[i]) << i;
  }
}

TEST(GridSoundings, ConvergesWithTheSquareOfTheDistance)
{
  const auto errorFor = [](std::size_t count) {
    return errorOf(gridSoundings(scatter(count, { 1000.0, 1000.0 }, wavy), local(10.0)), wavy, 1000.0, 100.0).rms;
  };
  const double coarse = errorFor(4000);
  const double fine = errorFor(64000);
  const double order = std::log(coarse / fine) / std::log(4.0);
  EXPECT_GT(order, 1.8) << coarse << " " << fine;
  EXPECT_LT(order, 2.2) << coarse << " " << fine;
}

TEST(GridSoundings, LeftOutErrorAgreesWithTheTrueOne)
{
  const GriddedSoundings result = gridSoundings(scatter(10000, { 1000.0, 1000.0 }, wavy), local(5.0));
  const Error error = errorOf(result, wavy, 1000.0, 50.0);
  // A sounding left out lies farther from the others than a node does: for random places the mean square of the
  // distance is twice as large, and so is the error.
  EXPECT_GT(result.report.single.rms, error.rms);
  EXPECT_LT(result.report.single.rms, 4.0 * error.rms);
  EXPECT_GT(result.report.single.count, 9900U);
}

TEST(GridSoundings, IsTheSameForAnyNumberOfThreads)
{
  const Soundings soundings = scatter(3000, { 500.0, 400.0 }, wavy);
  SeafloorOptions options = local(5.0);
  options.crossValidate = true;
  Execution threads;
  threads.loop = [](std::size_t n, const std::function<void(std::size_t, std::size_t)>& body)
  {
    std::vector<std::thread> running;
    for (std::size_t part = 0; part < 7; ++part)
    {
      running.emplace_back([=, &body] { body(n * part / 7, n * (part + 1) / 7); });
    }
    for (std::thread& thread : running)
    {
      thread.join();
    }
  };
  const GriddedSoundings one = gridSoundings(soundings, options);
  const GriddedSoundings many = gridSoundings(soundings, options, threads);
  ASSERT_EQ(one.grid.elevation.size(), many.grid.elevation.size());
  for (std::size_t i = 0; i < one.grid.elevation.size(); ++i)
  {
    const double a = one.grid.elevation[i];
    const double b = many.grid.elevation[i];
    ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << i;
  }
  EXPECT_EQ(one.report.single.rms, many.report.single.rms);
  EXPECT_EQ(one.report.tenth.rms, many.report.tenth.rms);
  EXPECT_GT(one.report.tenth.count, 2900U);
}

TEST(GridSoundings, TakesDuplicatesForTheirMean)
{
  Soundings soundings = scatter(500, { 100.0, 100.0 }, plane);
  soundings.add(soundings.x[7], soundings.y[7], soundings.z[7] + 0.5);
  soundings.add(soundings.x[7], soundings.y[7], soundings.z[7] - 0.5);
  const GriddedSoundings result = gridSoundings(soundings, local(5.0));
  EXPECT_EQ(result.report.duplicates, 2U);
  EXPECT_NEAR(result.report.duplicateSpread, 1.0, 1e-12);
  EXPECT_LT(errorOf(result, plane, 100.0, 0.0).largest, ExactElevation);
}

TEST(GridSoundings, FindsOutliersAndDropsThemWhereAsked)
{
  Soundings soundings = scatter(4000, { 1000.0, 1000.0 }, wavy);
  for (const std::size_t wrong : { 100U, 2000U, 3333U })
  {
    soundings.z[wrong] += wrong == 2000U ? -6.0 : 4.0;
  }
  SeafloorOptions options = local(10.0);
  const GriddedSoundings kept = gridSoundings(soundings, options);
  EXPECT_EQ(kept.report.outliers, 3U);
  EXPECT_FALSE(kept.report.outliersDropped);
  EXPECT_EQ(kept.report.worstOutlierPlace, glm::dvec2(soundings.x[2000], soundings.y[2000]));
  EXPECT_NEAR(kept.report.worstOutlier, 6.0, 0.5);
  EXPECT_GT(kept.report.single.largest, 5.0);

  options.dropOutliers = true;
  const GriddedSoundings dropped = gridSoundings(soundings, options);
  EXPECT_EQ(dropped.report.outliers, 3U);
  EXPECT_EQ(dropped.report.used, 3997U);
  const Error clean = errorOf(gridSoundings(scatter(4000, { 1000.0, 1000.0 }, wavy), options), wavy, 1000.0, 100.0);
  EXPECT_LT(errorOf(dropped, wavy, 1000.0, 100.0).rms, 1.1 * clean.rms);
  EXPECT_GT(errorOf(kept, wavy, 1000.0, 100.0).rms, 2.0 * clean.rms);
}

TEST(GridSoundings, LeavesHolesBeyondMaxGap)
{
  Soundings all = scatter(10000, { 1000.0, 1000.0 }, plane);
  Soundings ring;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (std::hypot(all.x[i] - 500.0, all.y[i] - 500.0) > 200.0)
    {
      ring.add(all.x[i], all.y[i], all.z[i]);
    }
  }
  SeafloorOptions options = local(10.0);
  const GriddedSoundings byDefault = gridSoundings(ring, options);
  EXPECT_TRUE(byDefault.report.maxGapChosen);
  // Random soundings 10 m apart: gaps of some times that are closed, one of 400 m is not.
  EXPECT_GT(byDefault.report.maxGap, 15.0);
  EXPECT_LT(byDefault.report.maxGap, 40.0);
  EXPECT_TRUE(std::isnan(byDefault.grid.at(50, 50)));
  EXPECT_FALSE(std::isnan(byDefault.grid.at(20, 50)));

  options.maxGap = 100.0;
  const GriddedSoundings narrow = gridSoundings(ring, options);
  for (std::size_t column = 0; column < narrow.grid.columns; ++column)
  {
    const double x = narrow.georeference.toFile(narrow.grid.node(column, 50)).x;
    const double toData = 200.0 - std::abs(x - 500.0);
    if (std::abs(toData - 100.0) > 20.0 && x > 10.0 && x < 990.0)
    {
      EXPECT_EQ(std::isnan(narrow.grid.at(column, 50)), toData > 100.0) << x;
    }
  }
  options.maxGap = 300.0;
  EXPECT_FALSE(std::isnan(gridSoundings(ring, options).grid.at(50, 50)));
}

TEST(GridSoundings, CoversWhatTheCellsCover)
{
  // A mesh of squares with one left out, one with a node without a value, and a bay in its outline.
  Soundings mesh;
  for (int row = 0; row <= 10; ++row)
  {
    for (int column = 0; column <= 10; ++column)
    {
      const bool masked = row == 7 && column == 7;
      mesh.add(100.0 * column, 100.0 * row, masked ? std::nan("") : plane({ 100.0 * column, 100.0 * row }));
    }
  }
  mesh.cellOffsets.push_back(0);
  for (std::uint32_t row = 0; row < 10; ++row)
  {
    for (std::uint32_t column = 0; column < 10; ++column)
    {
      if ((row == 3 && column == 3) || (row >= 8 && column >= 4 && column < 6))
      {
        continue;
      }
      const std::uint32_t first = row * 11 + column;
      mesh.cellNodes.insert(mesh.cellNodes.end(), { first, first + 11, first + 12, first + 1 });
      mesh.cellOffsets.push_back(mesh.cellNodes.size());
    }
  }
  const GriddedSoundings result = gridSoundings(mesh, local(25.0));
  const auto hole = [&result](double x, double y)
  { return std::isnan(result.grid.at(static_cast<std::size_t>(x / 25.0), static_cast<std::size_t>(y / 25.0))); };
  EXPECT_TRUE(hole(350.0, 350.0));
  EXPECT_FALSE(hole(300.0, 350.0)); // on the rim
  EXPECT_TRUE(hole(650.0, 650.0));
  EXPECT_TRUE(hole(750.0, 750.0));
  EXPECT_TRUE(hole(500.0, 950.0));
  EXPECT_FALSE(hole(500.0, 800.0));
  EXPECT_FALSE(hole(0.0, 1000.0));
  EXPECT_EQ(result.report.cells, mesh.cellOffsets.size() - 1);
  EXPECT_LT(errorOf(result, plane, 1000.0, 0.0).largest, ExactElevation);
}

TEST(GridSoundings, WorksInMetresOnLongitudeAndLatitude)
{
  // Flat in the west, rising eastward by 1 m in 100 m: on the map the same slope whatever a degree is.
  const double metresPerDegree = 6378137.0 * 3.14159265358979 / 180.0;
  const auto bed = [=](const glm::dvec2& p)
  { return -20.0 + 0.01 * (p.x + 179.9) * metresPerDegree * std::cos(1.0471975511966); };
  Soundings soundings = scatter(3000, { 0.02, 0.01 }, [](const glm::dvec2&) { return 0.0; });
  for (std::size_t i = 0; i < soundings.size(); ++i)
  {
    // Across the antimeridian.
    const double east = 179.99 + soundings.x[i];
    soundings.y[i] += 59.995;
    soundings.z[i] = bed({ east - 360.0, soundings.y[i] });
    soundings.x[i] = east > 180.0 ? east - 360.0 : east;
  }
  soundings.crs = "EPSG:4326";
  SeafloorOptions options;
  options.resample = 20.0;
  const GriddedSoundings result = gridSoundings(soundings, options);
  EXPECT_EQ(result.georeference.kind(), GeoreferenceKind::Geographic);
  EXPECT_NEAR(std::abs(result.georeference.originLongitude()), 180.0, 1e-4);
  EXPECT_NEAR(result.grid.bounds().size().x, 1115.0, 25.0);
  const std::size_t row = result.grid.rows / 2;
  const double rise = result.grid.at(result.grid.columns - 5, row) - result.grid.at(4, row);
  // A degree at 60 degrees on the ellipsoid is 0.25 % longer than on the sphere of the equator's radius.
  EXPECT_NEAR(rise, 0.01 * 20.0 * static_cast<double>(result.grid.columns - 9), 0.01 * rise);
}

TEST(GridSoundings, ReadsUnitsSignsAndMarks)
{
  Soundings soundings = scatter(500, { 100.0, 100.0 }, plane);
  for (double& z : soundings.z)
  {
    z *= -1.0 / 0.3048;
  }
  soundings.z[3] = 99999.0;
  soundings.vertical.units = "feet";
  soundings.vertical.rule = "down";
  soundings.vertical.ruleSource = "test format";
  SeafloorOptions options = local(5.0);
  EXPECT_THROW(gridSoundings(soundings, options), std::runtime_error);
  options.nodata = 99999.0;
  const GriddedSoundings result = gridSoundings(soundings, options);
  EXPECT_EQ(result.report.missing, 1U);
  EXPECT_EQ(result.report.count, 499U);
  EXPECT_EQ(result.meaning.signSource, "test format");
  EXPECT_LT(errorOf(result, plane, 100.0, 0.0).largest, ExactElevation);
}

TEST(GridSoundings, ChoosesItsSpacingFromTheDistanceOfSoundings)
{
  SeafloorOptions options;
  options.crs = "local";
  const GriddedSoundings result = gridSoundings(scatter(10000, { 1000.0, 1000.0 }, wavy), options);
  EXPECT_TRUE(result.report.spacingChosen);
  EXPECT_NEAR(result.report.spacing, 10.0, 0.5);
}

TEST(GridSoundings, CropsTheGridNotTheSoundings)
{
  SeafloorOptions options = local(10.0);
  options.crop = { 300.0, 400.0, 500.0, 700.0 };
  const GriddedSoundings result = gridSoundings(scatter(2000, { 1000.0, 1000.0 }, plane), options);
  EXPECT_EQ(result.grid.columns, 21U);
  EXPECT_EQ(result.grid.rows, 31U);
  EXPECT_EQ(result.report.holes, 0U);
  EXPECT_EQ(result.georeference.originX(), 300.0);
  EXPECT_LT(errorOf(result, plane, 1000.0, 0.0).largest, ExactElevation);
  options.crop = { 3000.0, 400.0, 5000.0, 700.0 };
  EXPECT_THROW(gridSoundings(scatter(2000, { 1000.0, 1000.0 }, plane), options), std::runtime_error);
}

std::string messageOf(const Soundings& soundings, const SeafloorOptions& options)
{
  try
  {
    gridSoundings(soundings, options);
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return {};
}

TEST(GridSoundings, RefusesWhatMakesNoSurface)
{
  using testing::HasSubstr;
  const SeafloorOptions options = local(10.0);
  EXPECT_THAT(messageOf({}, options), HasSubstr("no soundings"));
  EXPECT_THAT(messageOf(scatter(2, { 100.0, 100.0 }, plane), options), HasSubstr("at least 3"));
  EXPECT_THAT(messageOf(scatter(50, { 100.0, 0.0 }, plane), options), HasSubstr("on one line"));
  Soundings same;
  for (int i = 0; i < 20; ++i)
  {
    same.add(1.0, 2.0, -3.0);
  }
  EXPECT_THAT(messageOf(same, options), HasSubstr("at 1 places"));
  EXPECT_THAT(messageOf(scatter(50, { 100.0, 100.0 }, plane), local(90.0)), HasSubstr("fewer than 4 x 4"));
  EXPECT_THAT(messageOf(scatter(50, { 1e6, 1e6 }, wavy), local(1.0)), HasSubstr("million nodes"));
  Soundings far = scatter(50, { 100.0, 100.0 }, plane);
  far.add(1e200, 3.0, -4.0);
  EXPECT_THAT(messageOf(far, options), HasSubstr("at 1e+200, 3, which is no place on Earth"));
  Soundings short1 = scatter(50, { 100.0, 100.0 }, plane);
  short1.z.pop_back();
  EXPECT_THROW(gridSoundings(short1, options), std::invalid_argument);
  Soundings cells = scatter(50, { 100.0, 100.0 }, plane);
  cells.cellOffsets = { 0, 3 };
  cells.cellNodes = { 0, 1, 50 };
  EXPECT_THROW(gridSoundings(cells, options), std::invalid_argument);
}

}
