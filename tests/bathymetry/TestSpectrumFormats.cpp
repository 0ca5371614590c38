// Spectra in NetCDF and of buoys: both conventions of direction, units, what is missing and what is damaged; times.
#include "bathymetry/CalendarTime.h"
#include "bathymetry/SpectrumFile.h"
#include "sim/Angles.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

using namespace swellray;

namespace
{

namespace fs = std::filesystem;

// Directions are written in degrees, densities as they are.
constexpr double Rounding = 1e-9;

// Bins of 5 degrees lessen the first moment by sin(2.5 degrees)/2.5 degrees, 0.0003, the second by four times that.
constexpr double Bins = 1.5e-3;

std::string temporary(const std::string& name)
{
  return (fs::path(testing::TempDir()) / name).string();
}

std::string write(const std::string& name, const std::string& text)
{
  const std::string path = temporary(name);
  std::ofstream(path) << text;
  return path;
}

std::string messageOf(const std::string& path)
{
  try
  {
    readSpectra(path);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}

SpectrumRecord record(double from, const std::string& time, const glm::dvec2& place)
{
  SpectrumRecord made;
  made.time = time;
  made.place = place;
  made.geographic = true;
  made.spectrum = DirectionalSpectrum::sample(SpectralGrid::logarithmic(0.04, 0.5, 12, 24),
    FrequencySpectrum::jonswap(2.0, 9.0), DirectionalSpreading::cosinePower(radians(25.0)), headingFromNautical(from));
  return made;
}

struct Axis
{
  std::string name;
  std::vector<double> values;
  std::string unit;
  std::string standardName;
};

// A NetCDF file with a variable over axes, values counting its nodes from 0.
void makeNetcdf(const std::string& path, const std::vector<Axis>& axes, const std::string& unit, double step)
{
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("netCDF");
  const std::unique_ptr<GDALDataset> dataset(driver->CreateMultiDimensional(path.c_str(), nullptr, nullptr));
  const auto root = dataset->GetRootGroup();
  const auto type = GDALExtendedDataType::Create(GDT_Float64);
  const auto say = [](GDALMDArray& array, const char* name, const std::string& value)
  { array.CreateAttribute(name, {}, GDALExtendedDataType::CreateString())->Write(value.c_str()); };
  std::vector<std::shared_ptr<GDALDimension>> dimensions;
  std::vector<GUInt64> start;
  std::vector<std::size_t> count;
  std::size_t size = 1;
  for (const Axis& axis : axes)
  {
    dimensions.push_back(root->CreateDimension(axis.name, "", "", axis.values.size()));
    const auto array = root->CreateMDArray(axis.name, { dimensions.back() }, type);
    say(*array, "units", axis.unit);
    say(*array, "standard_name", axis.standardName);
    const GUInt64 first = 0;
    const std::size_t all = axis.values.size();
    array->Write(&first, &all, nullptr, nullptr, type, axis.values.data());
    start.push_back(0);
    count.push_back(all);
    size *= all;
  }
  const auto array = root->CreateMDArray("efth", dimensions, type);
  say(*array, "units", unit);
  std::vector<double> values(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    values[i] = step * static_cast<double>(i);
  }
  array->Write(start.data(), count.data(), nullptr, nullptr, type, values.data());
}

}

TEST(NetcdfSpectra, comeBackAsTheyWereWritten)
{
  const std::string path = temporary("spectra.nc");
  const std::vector<SpectrumRecord> written{ record(300.0, "2026-01-01T00:00", { 4.25, 52.0 }),
    record(310.0, "2026-01-01T00:00", { 4.5, 52.5 }), record(320.0, "20260101.013000", { 4.25, 52.0 }),
    record(20.0, "20260101.013000", { 4.5, 52.5 }) };
  writeNetcdfSpectra(path, written, "a test");
  const SpectrumFile file = readSpectra(path);
  EXPECT_EQ(file.format, "NetCDF");
  EXPECT_TRUE(file.notes.empty());
  ASSERT_EQ(file.records.size(), 4u);
  for (std::size_t r = 0; r < 4; ++r)
  {
    const SpectrumRecord& read = file.records[r];
    EXPECT_EQ(read.time, r < 2 ? "2026-01-01T00:00:00" : "2026-01-01T01:30:00");
    EXPECT_EQ(*read.place, *written[r].place);
    EXPECT_TRUE(read.geographic);
    EXPECT_EQ(read.spectrum.grid.frequencies, written[r].spectrum.grid.frequencies);
    ASSERT_EQ(read.spectrum.grid.headings.size(), 24u);
    for (std::size_t i = 0; i < 12; ++i)
    {
      for (double heading = 0.05; heading < 6.2; heading += 0.3)
      {
        const double f = written[r].spectrum.grid.frequencies[i];
        EXPECT_NEAR(read.spectrum.interpolate(f, heading), written[r].spectrum.interpolate(f, heading), Rounding);
      }
    }
  }
  EXPECT_NEAR(seaParameters(file.records[3].spectrum).meanDirectionFrom, 20.0, 1e-6);
  EXPECT_THROW(writeNetcdfSpectra(path, {}, ""), std::invalid_argument);
  EXPECT_THROW(writeNetcdfSpectra(path, { written[0], written[1], written[2] }, ""), std::invalid_argument);
  EXPECT_THROW(writeNetcdfSpectra(path, { record(0.0, "noon", { 0.0, 0.0 }) }, ""), std::invalid_argument);
}

TEST(NetcdfSpectra, directionsMeanWhatTheirStandardNameSays)
{
  // Node i: value i. The largest is the last: frequency 0.2 Hz, direction 270.
  const Axis frequency{ "frequency", { 0.1, 0.15, 0.2 }, "s-1", "wave_frequency" };
  const std::vector<double> degrees{ 0.0, 90.0, 180.0, 270.0 };
  const std::string path = temporary("ww3.nc");
  const Axis time{ "time", { 12345.5 }, "days since 1990-01-01 00:00:00", "time" };
  const Axis station{ "station", { 1.0 }, "1", "" };
  makeNetcdf(path, { time, station, frequency, { "direction", degrees, "degree", "sea_surface_wave_to_direction" } },
    "m2 s rad-1", 1.0);
  SpectrumFile file = readSpectra(path);
  ASSERT_EQ(file.records.size(), 1u);
  EXPECT_EQ(file.records[0].time, "2023-10-20T12:00:00");
  EXPECT_FALSE(file.records[0].place.has_value());
  // Going to 270 degrees, west.
  EXPECT_NEAR(file.records[0].spectrum.interpolate(0.2, Pi), 11.0, Rounding);
  EXPECT_NEAR(file.records[0].spectrum.interpolate(0.1, 0.5 * Pi), 0.0, Rounding);
  EXPECT_NEAR(file.records[0].spectrum.interpolate(0.15, 0.0), 5.0, Rounding);

  // Other order, other units, coming from; no time and no station.
  makeNetcdf(path, { { "direction", degrees, "degree", "sea_surface_wave_from_direction" }, frequency },
    "m2 Hz-1 degree-1", 1.0);
  file = readSpectra(path);
  ASSERT_EQ(file.records.size(), 1u);
  EXPECT_EQ(file.records[0].time, "");
  // From 270 degrees is going east; the last value again.
  EXPECT_NEAR(file.records[0].spectrum.interpolate(0.2, 0.0), 11.0 * 180.0 / Pi, 1e-6);
  EXPECT_NEAR(file.records[0].spectrum.interpolate(0.15, 1.5 * Pi), 1.0 * 180.0 / Pi, 1e-6); // from the north
}

TEST(NetcdfSpectra, sayWhatIsWrong)
{
  const std::string path = temporary("bad_spectra.nc");
  const Axis frequency{ "frequency", { 0.1, 0.15, 0.2 }, "s-1", "wave_frequency" };
  const Axis direction{ "direction", { 0.0, 90.0, 180.0, 270.0 }, "degree", "sea_surface_wave_to_direction" };
  makeNetcdf(path, { frequency, { "other", { 1.0, 2.0 }, "", "" } }, "m2 s", 1.0);
  EXPECT_NE(messageOf(path).find("none of direction"), std::string::npos) << messageOf(path);
  makeNetcdf(path, { { "frequency", { 0.1, 0.2 }, "rad s-1", "" }, direction }, "m2 s rad-1", 1.0);
  EXPECT_NE(messageOf(path).find("Hz are needed"), std::string::npos) << messageOf(path);
  makeNetcdf(path, { frequency, direction }, "m2 s rad-1", -1.0);
  EXPECT_NE(messageOf(path).find("no whole spectrum"), std::string::npos) << messageOf(path);
  makeNetcdf(path, { { "frequency", { 0.2, 0.1 }, "s-1", "" }, direction }, "m2 s rad-1", 1.0);
  EXPECT_NE(messageOf(path).find("must increase"), std::string::npos) << messageOf(path);
  std::ofstream(path) << "CDF and nothing more";
  EXPECT_NE(messageOf(path).find("bad_spectra.nc"), std::string::npos);
}

TEST(NdbcSpectra, yearsOfABuoyAreSpreadByTheirMoments)
{
  const std::string head = "#YY  MM DD hh mm   .0500  .1000  .1500\n";
  write("46042d2010.txt", head + "2010 01 02 03 00 999.0 300.0 280.0\n2010 01 02 04 00 999.0 999.0 999.0\n");
  write("46042i2010.txt", head + "2010 01 02 03 00 999.0 305.0 280.0\n");
  write("46042j2010.txt", head + "2010 01 02 03 00 999.0 85.0 60.0\n2010 01 02 04 00 999.0 999.0 999.0\n");
  write("46042k2010.txt", head + "2010 01 02 03 00 999.0 60.0 30.0\n");
  const std::string path =
    write("46042w2010.txt", head + "2010 01 02 03 00 0.00 4.00 2.00\n2010 01 02 04 00 0.00 1.00 1.00\n");
  const SpectrumFile file = readSpectra(path);
  EXPECT_EQ(file.format, "NDBC");
  ASSERT_EQ(file.records.size(), 1u); // the second time has no directions
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_NE(file.notes[0].find("1 times have no directions"), std::string::npos);
  EXPECT_EQ(file.records[0].time, "2010-01-02T03:00");
  const DirectionalSpectrum& spectrum = file.records[0].spectrum;
  const std::vector<double> over = spectrum.overFrequency();
  EXPECT_NEAR(over[0], 0.0, Rounding);
  EXPECT_NEAR(over[1], 4.0, Rounding);
  EXPECT_NEAR(over[2], 2.0, Rounding);
  const double width = 2.0 * Pi / StandardDirections;
  const double wanted[2][4] = { { 300.0, 0.85, 305.0, 0.60 }, { 280.0, 0.60, 280.0, 0.30 } };
  for (std::size_t i = 1; i < 3; ++i)
  {
    glm::dvec2 first(0.0);
    glm::dvec2 second(0.0);
    for (std::size_t j = 0; j < StandardDirections; ++j)
    {
      const double heading = spectrum.grid.headings[j];
      const double share = spectrum.at(i, j) * width / over[i];
      first += share * glm::dvec2(std::cos(heading), std::sin(heading));
      second += share * glm::dvec2(std::cos(2.0 * heading), std::sin(2.0 * heading));
    }
    const double* moment = wanted[i - 1];
    EXPECT_NEAR(first.x, moment[1] * std::cos(headingFromNautical(moment[0])), Bins);
    EXPECT_NEAR(first.y, moment[1] * std::sin(headingFromNautical(moment[0])), Bins);
    EXPECT_NEAR(second.x, moment[3] * std::cos(2.0 * headingFromNautical(moment[2])), Bins);
    EXPECT_NEAR(second.y, moment[3] * std::sin(2.0 * headingFromNautical(moment[2])), Bins);
  }
}

TEST(NdbcSpectra, theLastDaysOfABuoyComeInPairs)
{
  write("46042.swdir", "#YY  MM DD hh mm < alpha1_1 (freq_1) ... >\n2026 11 22 10 40 120.0 (0.050) 130.0 (0.100)\n");
  write("46042.swr1", "#YY  MM DD hh mm < r1_1 (freq_1) ... >\n2026 11 22 10 40 0.80 (0.050) 0.70 (0.100)\n");
  fs::remove(temporary("46042.swdir2"));
  fs::remove(temporary("46042.swr2"));
  const std::string path = write("46042.data_spec",
    "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) ... >\n2026 11 22 10 40 9.999 3.000 (0.050) 1.000 (0.100)\n");
  const SpectrumFile file = readSpectra(path);
  ASSERT_EQ(file.records.size(), 1u);
  const SeaParameters sea = seaParameters(file.records[0].spectrum);
  EXPECT_NEAR(sea.significantHeight, 4.0 * std::sqrt(0.5 * 0.05 * (3.0 + 1.0)), Rounding);
  const double east = 3.0 * 0.8 * std::cos(headingFromNautical(120.0)) + 0.7 * std::cos(headingFromNautical(130.0));
  const double north = 3.0 * 0.8 * std::sin(headingFromNautical(120.0)) + 0.7 * std::sin(headingFromNautical(130.0));
  EXPECT_NEAR(sea.meanDirectionFrom, nauticalFromVector({ east, north }), 0.01);
}

TEST(NdbcSpectra, sayWhereAFileIsBroken)
{
  const std::string head = "YYYY MM DD hh .05 .10\n";
  EXPECT_NE(messageOf(write("nowhere.txt", head + "2000 01 01 00 1 2\n")).find("no directions"), std::string::npos);
  EXPECT_NE(messageOf(write("51001w1999.txt", head + "2000 01 01 00 1 2\n")).find("51001d1999.txt"), std::string::npos);
  EXPECT_NE(messageOf(write("51002w1999.txt", head + "2000 01 01 00 1\n")).find("line 2"), std::string::npos);
  EXPECT_NE(messageOf(write("51003w1999.txt", head + "2000 13 01 00 1 2\n")).find("is no time"), std::string::npos);
  EXPECT_NE(
    messageOf(write("51004w1999.txt", head + "2000 01 01 00 1 x\n")).find("'x' is no value"), std::string::npos);
  EXPECT_NE(messageOf(write("51005w1999.txt", head)).find("holds no values"), std::string::npos);
}

TEST(CalendarTime, countsSecondsFrom1970)
{
  EXPECT_EQ(secondsOfTime("1970-01-01"), 0.0);
  EXPECT_EQ(secondsOfTime("2000-03-01T00:00"), 951868800.0);
  EXPECT_EQ(secondsOfTime("2024-02-29 12:00:30"), 1709208030.0);
  EXPECT_EQ(secondsOfTime("20240229.120030"), 1709208030.0);
  EXPECT_EQ(secondsOfTime("1969-12-31T23:59:59"), -1.0);
  EXPECT_FALSE(secondsOfTime("2024-13-01").has_value());
  EXPECT_FALSE(secondsOfTime("noon").has_value());
  EXPECT_FALSE(secondsOfTime("").has_value());
  EXPECT_EQ(timeOfSeconds(1709208030.0), "2024-02-29T12:00:30");
  EXPECT_EQ(timeOfSeconds(-1.0), "1969-12-31T23:59:59");
  for (double seconds = -5e9; seconds < 5e9; seconds += 123456789.0)
  {
    EXPECT_EQ(secondsOfTime(timeOfSeconds(seconds)), seconds);
  }
  EXPECT_EQ(secondsOfUnits(1.5, "days since 2000-03-01 00:00:00"), 951868800.0 + 129600.0);
  EXPECT_EQ(secondsOfUnits(2.0, "hours since 2000-03-01T00:00:00Z"), 951868800.0 + 7200.0);
  EXPECT_FALSE(secondsOfUnits(2.0, "fortnights since 2000-03-01").has_value());
  EXPECT_FALSE(secondsOfUnits(2.0, "m").has_value());
}
