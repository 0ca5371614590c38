#include "RasterFile.h"

#include "bathymetry/TextSoundings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>

using namespace swellray;
using namespace swellray::test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace
{

class TextSoundingsTest : public testing::Test
{
protected:
  Soundings read(const std::string& text, const std::string& variable = {})
  {
    const std::string path = this->Files.file("soundings.xyz");
    std::ofstream(path, std::ios::binary) << text;
    return readTextSoundings(path, variable);
  }

  std::string errorOf(const std::string& text, const std::string& variable = {})
  {
    try
    {
      this->read(text, variable);
    }
    catch (const std::runtime_error& error)
    {
      return error.what();
    }
    return "no error";
  }

  Folder Files;
};

TEST_F(TextSoundingsTest, NumbersSeparatedByAnything)
{
  for (const char* const text : {
         "431200.5 5312000.25 -12.5\n431201 5312001 3\n",
         "  431200.5\t5312000.25   -1.25e1\r\n\r\n431201 5312001 +3\r\n",
         "431200.5,5312000.25,-12.5\n431201, 5312001, 3",
         "431200.5;5312000.25;-12.5\n431201; 5312001; 3\n",
         "431200,5;5312000,25;-12,5\n431201; 5312001; 3\n",
         "431200,5 5312000,25 -12,5\n431201,0 5312001,0 3,0\n",
         "# a comment\n% another\n431200.5 5312000.25 -12.5D+00\n// a third\n431201 5312001 3\n",
         "\xEF\xBB\xBF\"431200.5\",\"5312000.25\",\"-12.5\"\n\"431201\",\"5312001\",\"3\"\n",
       })
  {
    const Soundings soundings = this->read(text);
    EXPECT_THAT(soundings.x, ElementsAre(431200.5, 431201.0)) << text;
    EXPECT_THAT(soundings.y, ElementsAre(5312000.25, 5312001.0)) << text;
    EXPECT_THAT(soundings.z, ElementsAre(-12.5, 3.0)) << text;
    EXPECT_EQ(soundings.crs, "") << text;
    EXPECT_THAT(soundings.notes, IsEmpty()) << text;
  }
}

TEST_F(TextSoundingsTest, ColumnsByTheirNames)
{
  for (const char* const text : {
         "lat,lon,depth\n60.5,-3.5,20\n",
         "# Latitude; Longitude; Depth (m)\n60.5;-3.5;20\n",
         "time,LON,LAT,quality,depth_m\n2017-05-18T11:34,-3.5,60.5,good,20\n",
         "Survey of the bay\nthree lines of text\nlat lon depth\n60.5 -3.5 20\n",
         "lon[deg]\tlat[deg]\tuncertainty\tdepth [m]\n-3.5\t60.5\t0.1\t20\n",
       })
  {
    const Soundings soundings = this->read(text);
    EXPECT_THAT(soundings.x, ElementsAre(-3.5)) << text;
    EXPECT_THAT(soundings.y, ElementsAre(60.5)) << text;
    EXPECT_THAT(soundings.z, ElementsAre(20.0)) << text;
    EXPECT_EQ(soundings.crs, "EPSG:4326") << text;
    EXPECT_EQ(soundings.variable, "depth") << text;
  }
  const Soundings feet = this->read("Northing,Easting,Elev (ft)\n200,100,-30\n");
  EXPECT_THAT(feet.x, ElementsAre(100.0));
  EXPECT_THAT(feet.z, ElementsAre(-30.0));
  EXPECT_EQ(feet.vertical.units, "ft");
  EXPECT_EQ(feet.crs, "");
  // A column of the rows' own has no name.
  const Soundings counted = this->read("\teasting\tnorthing\televation\n0\t1\t2\t3\n1\t4\t5\t6\n");
  EXPECT_THAT(counted.x, ElementsAre(1.0, 4.0));
  EXPECT_THAT(counted.z, ElementsAre(3.0, 6.0));
}

TEST_F(TextSoundingsTest, ColumnsAskedFor)
{
  const std::string text = "x,y,depth,bed_2019\n1,2,3,4\n";
  EXPECT_THAT(this->read(text).z, ElementsAre(3.0));
  EXPECT_THAT(this->read(text, "bed_2019").z, ElementsAre(4.0));
  EXPECT_THAT(this->read(text, "4").z, ElementsAre(4.0));
  EXPECT_THAT(this->errorOf(text, "bed_2020"), HasSubstr("no column 'bed_2020'; there are x, y, depth, bed_2019"));
  EXPECT_THAT(this->errorOf(text, "5"), HasSubstr("no column '5'"));
  EXPECT_THAT(this->errorOf(text, "y"), HasSubstr("holds a coordinate"));
  EXPECT_THAT(this->errorOf("x,y,a,b\n1,2,3,4\n"), HasSubstr("Choose with --variable: x, y, a, b"));
}

TEST_F(TextSoundingsTest, ColumnsInOrderAreSaid)
{
  const Soundings counted = this->read("1 10 20 -3\n2 11 21 -4\n");
  EXPECT_THAT(counted.x, ElementsAre(10.0, 11.0));
  EXPECT_THAT(counted.z, ElementsAre(-3.0, -4.0));
  ASSERT_EQ(counted.notes.size(), 1U);
  EXPECT_THAT(counted.notes[0], HasSubstr("columns 2, 3 and 4 of 4 (the first counts the lines)"));
  const Soundings more = this->read("10 20 -3 0.1\n11 21 -4 0.1\n");
  EXPECT_THAT(more.z, ElementsAre(-3.0, -4.0));
  EXPECT_THAT(more.notes[0], HasSubstr("columns 1, 2 and 3 of 4"));
  const Soundings strange = this->read("rechts hoch tief\n10 20 -3\n");
  EXPECT_THAT(strange.x, ElementsAre(10.0));
  EXPECT_THAT(strange.notes[0], HasSubstr("not understood (rechts, hoch, tief)"));
}

TEST_F(TextSoundingsTest, PlacesWithoutAValue)
{
  const Soundings soundings = this->read("x,y,z\n1,2,3\n4,5,\n6,7,NaN\n8,9,n/a\n");
  ASSERT_EQ(soundings.size(), 4U);
  EXPECT_EQ(soundings.z[0], 3.0);
  EXPECT_TRUE(std::isnan(soundings.z[1]) && std::isnan(soundings.z[2]) && std::isnan(soundings.z[3]));
}

TEST_F(TextSoundingsTest, FaultsNameTheirLine)
{
  EXPECT_THAT(this->errorOf("1 2 3\n4 5 6\n7 eight 9\n"), HasSubstr("line 3, column 2: 'eight' is no number"));
  EXPECT_THAT(this->errorOf("1 2 3\n4 5\n"), HasSubstr("line 2 has 2 columns"));
  EXPECT_THAT(this->errorOf("x,y,z\n1,2,3\n1,2,3.4.5\n"), HasSubstr("line 3, column 3: '3.4.5' is no number"));
  EXPECT_THAT(this->errorOf("no numbers\nat all\n"), HasSubstr("none of its first 2 lines"));
  EXPECT_THAT(this->errorOf("1 2\n3 4\n"), HasSubstr("three columns"));
  EXPECT_THAT(this->errorOf(""), HasSubstr("none of its first 0 lines"));
  std::string wide;
  for (int i = 0; i < 40; ++i)
  {
    wide += "1.5 ";
  }
  EXPECT_THAT(this->errorOf(wide + "\n" + wide + "\n"), HasSubstr("40 numbers and no names: a matrix"));
}

TEST_F(TextSoundingsTest, ManyLinesInSeveralChunks)
{
  // 12 MB, so that lines are cut at the ends of what is read at once.
  std::string text;
  constexpr int count = 400000;
  for (int i = 0; i < count; ++i)
  {
    text += std::to_string(i) + ".25 " + std::to_string(2 * i) + ".5 -" + std::to_string(i % 977) + ".125\n";
  }
  const Soundings soundings = this->read(text);
  ASSERT_EQ(soundings.size(), static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    const auto index = static_cast<std::size_t>(i);
    ASSERT_EQ(soundings.x[index], i + 0.25);
    ASSERT_EQ(soundings.y[index], 2.0 * i + 0.5);
    ASSERT_EQ(soundings.z[index], -(i % 977) - 0.125);
  }
}

TEST_F(TextSoundingsTest, KnowsTextFromOther)
{
  const std::string path = this->Files.file("other");
  std::ofstream(path, std::ios::binary) << std::string("1 2 3\n\0", 7);
  EXPECT_FALSE(isText(path));
  EXPECT_FALSE(isText(this->Files.file("none")));
  std::ofstream(path, std::ios::binary) << "1 2 3\n";
  EXPECT_TRUE(isText(path));
}

}
