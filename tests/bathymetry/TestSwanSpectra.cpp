// SWAN spectral files: written and read back, in both conventions of direction, whole and broken.
#include "bathymetry/SpectrumFile.h"
#include "sim/Angles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

using namespace swellray;

namespace
{

namespace fs = std::filesystem;

// Values are written with 5 digits of the largest.
constexpr double Written = 1e-5;

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
  made.spectrum = DirectionalSpectrum::sample(SpectralGrid::logarithmic(0.04, 0.5, 30, 36),
    FrequencySpectrum::jonswap(2.0, 9.0), DirectionalSpreading::cosinePower(radians(25.0)), headingFromNautical(from));
  return made;
}

const std::string Begin = "SWAN   1          version\n$ a comment\n";
const std::string Frequencies = "AFREQ\n 3\n 0.10\n 0.15\n 0.25\n";
const std::string Heading = Begin + Frequencies;

}

TEST(SwanSpectra, comeBackAsTheyWereWritten)
{
  const std::string path = temporary("swan.sp2");
  const std::vector<SpectrumRecord> written{ record(300.0, "20260101.000000", { 10.0, 20.0 }),
    record(310.0, "20260101.000000", { 30.0, 40.0 }), record(320.0, "20260101.010000", { 10.0, 20.0 }),
    record(330.0, "20260101.010000", { 30.0, 40.0 }) };
  writeSwanSpectra(path, written, "a test");
  const SpectrumFile file = readSpectra(path);
  ASSERT_EQ(file.records.size(), 4u);
  for (std::size_t r = 0; r < 4; ++r)
  {
    const SpectrumRecord& read = file.records[r];
    EXPECT_EQ(read.time, written[r].time);
    EXPECT_EQ(*read.place, *written[r].place);
    const double top = *std::max_element(written[r].spectrum.density.begin(), written[r].spectrum.density.end());
    for (std::size_t i = 0; i < 30; ++i)
    {
      EXPECT_NEAR(read.spectrum.grid.frequencies[i], written[r].spectrum.grid.frequencies[i], 1e-6);
      for (const double heading : { 0.1, 1.3, 4.0 })
      {
        EXPECT_NEAR(read.spectrum.interpolate(read.spectrum.grid.frequencies[i], heading),
          written[r].spectrum.interpolate(written[r].spectrum.grid.frequencies[i], heading), 2.0 * Written * top);
      }
    }
    EXPECT_NEAR(seaParameters(read.spectrum).significantHeight, 2.0, 1e-4);
    EXPECT_NEAR(seaParameters(read.spectrum).meanDirectionFrom, 300.0 + 10.0 * static_cast<double>(r), 1e-3);
  }
}

TEST(SwanSpectra, knowBothConventionsOfDirectionAndEnergy)
{
  // One bin with energy: going towards 30 degrees from east, that is coming from 240 degrees.
  const std::string directions = "4\n 30\n 120\n 210\n 300\nQUANT\n 1\n";
  const std::string rows = "FACTOR\n 0.5\n 0 0 0 0\n 4 0 0 0\n 0 0\n 0 0\n";
  const std::string variance = "VaDens\nm2/Hz/degr\n -99\n";
  const SpectrumFile cartesian = readSpectra(write("c.sp2", Heading + "CDIR\n" + directions + variance + rows));
  ASSERT_EQ(cartesian.records.size(), 1u);
  const SeaParameters sea = seaParameters(cartesian.records[0].spectrum);
  EXPECT_NEAR(sea.meanDirectionFrom, 240.0, 1e-9);
  // m0 = 0.5 4 m2/Hz/degree times 90 degrees times 0.075 Hz
  EXPECT_NEAR(sea.significantHeight, 4.0 * std::sqrt(2.0 * 90.0 * 0.075), 1e-12);
  const SpectrumFile nautical = readSpectra(write("n.sp2", Heading + "NDIR\n" + directions + variance + rows));
  EXPECT_NEAR(seaParameters(nautical.records[0].spectrum).meanDirectionFrom, 30.0, 1e-9);
  const SpectrumFile energy =
    readSpectra(write("e.sp2", Heading + "NDIR\n" + directions + "EnDens\nJ/m2/Hz/degr\n -99\n" + rows));
  EXPECT_NEAR(seaParameters(energy.records[0].spectrum).significantHeight,
    sea.significantHeight / std::sqrt(1025.0 * 9.81), 1e-12);
}

TEST(SwanSpectra, oneDimensionalOnesAreSpreadAboutTheirDirection)
{
  const std::string places = "TIME\n 1\nLONLAT\n 2\n 4.5 52.0\n 4.6 52.1\n";
  const std::string quantities = "QUANT\n 3\nVaDens\nm2/Hz\n -99\nNDIR\ndegr\n -999\nDSPR\ndegr\n -9\n";
  const std::string body = "20260101.000000\nLOCATION 1\n 1.0 200 20\n 2.0 200 20\n -99 -999 -9\nNODATA\n"
                           "20260101.010000\nZERO\nLOCATION 2\n 0 -999 -9\n 2.0 350 10\n 1.0 350 10\n";
  const SpectrumFile read = readSpectra(write("one.bnd", Begin + places + Frequencies + quantities + body));
  ASSERT_EQ(read.records.size(), 3u);
  EXPECT_TRUE(read.records[0].geographic);
  EXPECT_NEAR(seaParameters(read.records[0].spectrum).meanDirectionFrom, 200.0, 1e-6);
  EXPECT_NEAR(seaParameters(read.records[0].spectrum).spread, 20.0, 0.1);
  EXPECT_NEAR(seaParameters(read.records[0].spectrum).significantHeight, 4.0 * std::sqrt(0.025 + 2.0 * 0.075), 1e-6);
  EXPECT_EQ(seaParameters(read.records[1].spectrum).significantHeight, 0.0);
  EXPECT_NEAR(seaParameters(read.records[2].spectrum).meanDirectionFrom, 350.0, 1e-6);
  EXPECT_EQ(read.records[2].time, "20260101.010000");
  EXPECT_EQ(read.records[2].place->x, 4.6);
}

TEST(SwanSpectra, sayWhereAFileIsBroken)
{
  EXPECT_NE(messageOf(temporary("none.bnd")).find("no such file"), std::string::npos);
  EXPECT_NE(messageOf(write("b1.bnd", "hello\n")).find("line 1"), std::string::npos);
  EXPECT_NE(messageOf(write("b2.bnd", "SWAN 1\nAFREQ\n 1e9\n")).find("line 3"), std::string::npos);
  EXPECT_NE(messageOf(write("b3.bnd", "SWAN 1\nAFREQ\n 3\n 0.1\n")).find("ends where"), std::string::npos);
  EXPECT_NE(
    messageOf(write("b4.bnd", "SWAN 1\nAFREQ\n 2\n 0.2\n 0.1\nQUANT\n 1\nVaDens\nm2/Hz\n -9\nLOCATION 1\n")), "");
  EXPECT_NE(
    messageOf(write("b5.bnd", Heading + "QUANT\n 1\nVaDens\nm2/Hz\n -9\nLOCATION 1\n 1\n 1\n 1\n")).find("direction"),
    std::string::npos);
  EXPECT_NE(
    messageOf(write("b6.bnd", Heading + "QUANT\n 1\nVaDens\nm2/Hz\n -9\n")).find("no spectrum"), std::string::npos);
}

TEST(SwanSpectra, haringvlietBoundariesAreWhatWasMeasured)
{
  const char* set = std::getenv("SWELLRAY_DATA");
  const fs::path folder = fs::path(set ? set : SWELLRAY_DATA_DEFAULT) / "sites" / "haringvliet_nl";
  if (!fs::exists(folder))
  {
    GTEST_SKIP() << "no measured data at " << folder;
  }
  // Hm0 3.19, 3.20, 3.56 and 3.53 m, travelling 9.8, 4.8, 2.8, 1.8 degrees north of east, spread 31.5 degrees, Tp 8.3 s.
  const double heights[] = { 3.19, 3.20, 3.56, 3.53 };
  const double headings[] = { 9.8, 4.8, 2.8, 1.8 };
  for (int i = 0; i < 4; ++i)
  {
    const SpectrumFile file = readSpectra((folder / ("f31har0" + std::to_string(i + 1) + ".bnd")).string());
    ASSERT_EQ(file.records.size(), 1u);
    const SeaParameters sea = seaParameters(file.records[0].spectrum);
    EXPECT_NEAR(sea.significantHeight, heights[i], 0.006) << i; // given to two digits behind the point
    EXPECT_NEAR(sea.meanDirectionFrom, 270.0 - headings[i], 0.06) << i;
    EXPECT_NEAR(sea.spread, 31.5, 0.1) << i;
    EXPECT_NEAR(sea.peakPeriod, 8.3, 0.35) << i; // frequencies are 0.01 Hz apart, half of which is 0.35 s
  }
}
