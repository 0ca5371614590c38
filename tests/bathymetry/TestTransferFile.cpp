// Transfer tables: written and read back, damaged, and of another scene.
#include "bathymetry/TransferFile.h"
#include "sim/Angles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

using namespace swellray;

namespace
{

namespace fs = std::filesystem;

// Directions are written in degrees: some roundings of 360.
constexpr double Rounding = 1e-12;

std::string temporary(const std::string& name)
{
  return (fs::path(testing::TempDir()) / name).string();
}

TransferTable smallTable()
{
  TransferTable table;
  table.scene = { "seafloor abc", "water level 0.5", "current none" };
  table.rays.grid = SpectralGrid::logarithmic(0.05, 0.3, 3, 8);
  table.rays.perDirection = 2;
  for (int p = 0; p < 3; ++p)
  {
    SpectralOrigins origins;
    origins.place = { 1.0 / 3.0 + p, -2.0e5 };
    origins.depth = p == 1 ? std::nan("") : 5.0 + p;
    for (int i = 0; i < 48 && p != 1; ++i)
    {
      const bool none = i % 5 == 0;
      origins.headings.push_back(none ? std::nan("") : 0.1 * i - 1.0);
      origins.gains.push_back(none ? 0.0 : 0.01 * i);
    }
    table.places.push_back(origins);
  }
  return table;
}

template <typename Call>
std::string messageOf(const Call& call)
{
  try
  {
    call();
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}

}

TEST(TransferFile, comesBackAsItWasWritten)
{
  const std::string path = temporary("transfer.nc");
  const TransferTable written = smallTable();
  writeTransferTable(path, written, "a test");
  writeTransferTable(path, written, "a test"); // over the old one
  EXPECT_FALSE(fs::exists(temporary(".transfer.nc.part")));
  const TransferTable read = readTransferTable(path);
  EXPECT_EQ(read.scene, written.scene);
  EXPECT_EQ(read.rays.grid.frequencies, written.rays.grid.frequencies);
  EXPECT_EQ(read.rays.grid.headings, written.rays.grid.headings);
  EXPECT_EQ(read.rays.perDirection, 2u);
  ASSERT_EQ(read.places.size(), 3u);
  for (std::size_t p = 0; p < 3; ++p)
  {
    const SpectralOrigins& a = written.places[p];
    const SpectralOrigins& b = read.places[p];
    EXPECT_EQ(a.place, b.place);
    ASSERT_EQ(a.headings.size(), b.headings.size());
    EXPECT_TRUE(a.depth == b.depth || (std::isnan(a.depth) && std::isnan(b.depth)));
    for (std::size_t i = 0; i < a.headings.size(); ++i)
    {
      EXPECT_EQ(a.gains[i], b.gains[i]);
      EXPECT_EQ(std::isnan(a.headings[i]), std::isnan(b.headings[i]));
      if (!std::isnan(a.headings[i]))
      {
        EXPECT_NEAR(std::remainder(a.headings[i] - b.headings[i], 2.0 * Pi), 0.0, Rounding);
      }
    }
  }
}

TEST(TransferFile, isCheckedToBelongToTheScene)
{
  const TransferTable table = smallTable();
  requireScene("t.nc", table, table.scene);
  const std::string other = messageOf(
    [&] {
      requireScene("t.nc", table, { "seafloor abc", "water level 1", "current none" });
    });
  EXPECT_NE(other.find("t.nc"), std::string::npos);
  EXPECT_NE(other.find("it has water level 0.5, not water level 1"), std::string::npos);
  EXPECT_NE(messageOf([&] { requireScene("t.nc", table, { "seafloor abc" }); }), "");
}

TEST(TransferFile, saysWhatIsWrong)
{
  const std::string text = temporary("no_table.nc");
  std::ofstream(text) << "This is no table.\n";
  EXPECT_NE(messageOf([&] { readTransferTable(text); }).find("no_table.nc"), std::string::npos);
  EXPECT_NE(messageOf([&] { readTransferTable(temporary("nowhere.nc")); }).find("nowhere.nc"), std::string::npos);
  TransferTable bad = smallTable();
  bad.places[0].gains[7] = -1.0;
  const std::string path = temporary("bad.nc");
  writeTransferTable(path, bad, "a test");
  EXPECT_NE(messageOf([&] { readTransferTable(path); }).find("makes no sense"), std::string::npos);
  // Cut off: whatever is left is refused, or whole.
  writeTransferTable(path, smallTable(), "a test");
  fs::resize_file(path, fs::file_size(path) / 2);
  EXPECT_NE(messageOf([&] { readTransferTable(path); }).find("bad.nc"), std::string::npos);
  EXPECT_NE(messageOf([&] { writeTransferTable(temporary("nowhere/t.nc"), smallTable(), ""); }).find("cannot write"),
    std::string::npos);
}
