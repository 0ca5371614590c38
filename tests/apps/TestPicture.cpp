#include "Program.h"

#include "apps/drawing/ColorMap.h"

#include <gtest/gtest.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace
{

bool canDraw()
{
  const char* display = std::getenv("DISPLAY");
  return (display && *display) || std::system("command -v Xvfb > /dev/null 2>&1") == 0;
}

// The software driver of OpenGL keeps some bytes and is unloaded before a leak checker could tell whose they are.
void tolerateTheDriver()
{
  const char* asan = std::getenv("ASAN_OPTIONS");
  setenv("ASAN_OPTIONS", ((asan ? asan : "") + std::string(":detect_leaks=0")).c_str(), 1);
}

}

TEST(Picture, ShowsTheRaysOverTheSeafloor)
{
  tolerateTheDriver();
  if (!canDraw())
  {
    GTEST_SKIP() << "neither a display nor Xvfb to draw with";
  }
  const ScratchFolder folder("picture");
  const std::string picture = folder / "island.png";
  ASSERT_EQ(
    runSwellray("render island --period 8 --direction 270 --height 1 --crests auto --size 640x480 -o " + picture), 0);
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(picture.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  int size[3];
  image->GetDimensions(size);
  EXPECT_EQ(size[0], 640);
  EXPECT_EQ(size[1], 480);
  ASSERT_EQ(image->GetScalarType(), VTK_UNSIGNED_CHAR);

  // A sheet without a map, or a map without rays, has far fewer colours, and none of the warm ones of the rays.
  constexpr std::size_t ManyColors = 3000;
  constexpr int ManyWarm = 500;
  std::set<int> colors;
  int warm = 0;
  const int channels = image->GetNumberOfScalarComponents();
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      colors.insert(pixel[0] << 16 | pixel[1] << 8 | pixel[2]);
      warm += channels >= 3 && pixel[0] > 200 && pixel[2] < 130 ? 1 : 0;
    }
  }
  EXPECT_GT(colors.size(), ManyColors);
  EXPECT_GT(warm, ManyWarm);
}

TEST(Picture, ShowsAMapInPlaceOfTheDepths)
{
  tolerateTheDriver();
  if (!canDraw())
  {
    GTEST_SKIP() << "neither a display nor Xvfb to draw with";
  }
  const ScratchFolder folder("map");
  const std::string map = folder / "plane.vti";
  ASSERT_EQ(runSwellray("trace plane --period 8 --direction 90 --height 1 --map-spacing 20 --map " + map), 0);

  // A row of pixels through the map; its depth rises from the shore in the west to 48 m in the east.
  const auto row = [&](const std::string& options)
  {
    const std::string picture = folder / "plane.png";
    EXPECT_EQ(runSwellray("render plane --size 640x480 --color-map cividis -o " + picture + options), 0);
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(picture.c_str());
    reader->Update();
    std::vector<double> places; // along the scale, of the pixels that have a colour of it
    const auto& maps = swellray::drawing::quantityMaps();
    for (int x = 60; x < 460; ++x)
    {
      const auto* pixel = static_cast<unsigned char*>(reader->GetOutput()->GetScalarPointer(x, 250, 0));
      constexpr int Steps = 500;
      for (int i = 0; i <= Steps; ++i)
      {
        const auto color = maps.back().second->rgb(double(i) / Steps);
        // Rounded to bytes twice: the pixel and its mean.
        constexpr double Rounded = 1.5 / 255.0;
        if (std::abs(color[0] - pixel[0] / 255.0) < Rounded && std::abs(color[1] - pixel[1] / 255.0) < Rounded &&
          std::abs(color[2] - pixel[2] / 255.0) < Rounded)
        {
          places.push_back(double(i) / Steps);
          break;
        }
      }
    }
    return places;
  };
  ASSERT_EQ(swellray::drawing::quantityMaps().back().first, "cividis");
  const std::vector<double> places = row(" --map " + map + " --map-by Depth");
  constexpr std::size_t Most = 350; // of 400: contours and land are in between
  ASSERT_GT(places.size(), Most);
  constexpr double Step = 0.05; // where a contour line or a label is mixed in
  for (std::size_t i = 1; i < places.size(); ++i)
  {
    EXPECT_GT(places[i], places[i - 1] - Step) << i;
  }
  EXPECT_LT(places.front(), 0.15);
  EXPECT_GT(places.back(), 0.8);
  EXPECT_LT(row("").size(), Most / 2);
}

TEST(Picture, ShowsTheWaterAndItsMovie)
{
  tolerateTheDriver();
  if (!canDraw())
  {
    GTEST_SKIP() << "neither a display nor Xvfb to draw with";
  }
  const ScratchFolder folder("scene");
  const std::string scene = "render bay --style scene --period 3 --direction 90 --height 0.4 --size 480x400 ";
  ASSERT_EQ(runSwellray(scene + "--camera 60,0,8,20,0,0 -o " + (folder / "bay.png")), 0);
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName((folder / "bay.png").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[0], 480);
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[1], 400);
  ASSERT_EQ(runSwellray(scene + "--camera aerial --times 0:0.2:0.1 -o " + (folder / "bay.ogv")), 0);
  std::ifstream movie(folder / "bay.ogv", std::ios::binary);
  std::string beginning(4, ' ');
  movie.read(beginning.data(), 4);
  EXPECT_EQ(beginning, "OggS");
}

TEST(Picture, CutsTheSeaWhereCrestsHangOver)
{
  tolerateTheDriver();
  if (!canDraw())
  {
    GTEST_SKIP() << "neither a display nor Xvfb to draw with";
  }
  const ScratchFolder folder("section");
  const std::string picture = folder / "section.png";
  ASSERT_EQ(runSwellray("render plane:slope=0.05,x1=150,y0=-10,y1=10 --style section --line 90,0,-5,0 --period 6 "
                        "--direction 90 --height 1.2 --profile airy --profile gonzato-lesaec --size 800x600 -o " +
              picture),
    0);
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(picture.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  ASSERT_EQ(image->GetDimensions()[0], 800);
  ASSERT_EQ(image->GetDimensions()[1], 600);
  // Water is blue, the air over it is pale, the bed is brown; lines between them are neither.
  const auto isWater = [](const unsigned char* pixel) { return pixel[2] > pixel[0] + 40; };
  const auto isAir = [](const unsigned char* pixel) { return pixel[0] > 230 && pixel[2] > pixel[0]; };
  const auto isBed = [](const unsigned char* pixel) { return pixel[0] > pixel[2] + 30; };
  int hanging[2] = { 0, 0 };
  int bed[2] = { 0, 0 };
  for (int x = 100; x < 760; ++x)
  {
    bool above[2] = { false, false };
    for (int y = 0; y < 600; ++y)
    {
      const auto* pixel = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
      // Pictures count from below: the second section comes first.
      const int panel = y < 280 ? 1 : 0;
      above[panel] = above[panel] || isAir(pixel);
      hanging[panel] += above[panel] && isWater(pixel);
      bed[panel] += isBed(pixel);
    }
  }
  EXPECT_EQ(hanging[0], 0) << "sines do not hang over";
  EXPECT_GT(hanging[1], 60) << "pixels of lips with air under them";
  EXPECT_GT(bed[0], 10000);
  EXPECT_NEAR(bed[1], bed[0], 0.05 * bed[0]);
}

TEST(Picture, PutsFramesIntoASheet)
{
  tolerateTheDriver();
  if (!canDraw())
  {
    GTEST_SKIP() << "neither a display nor Xvfb to draw with";
  }
  const ScratchFolder folder("sheet");
  const std::string scene = "render bay --style scene --period 3 --direction 90 --height 0.4 --camera aerial ";
  ASSERT_EQ(runSwellray(scene + "--times 0:2:1 --sheet 2 --size 804x804 -o " + (folder / "sheet.png")), 0);
  ASSERT_EQ(runSwellray(scene + "--time 1 --size 400x400 -o " + (folder / "frame.png")), 0);
  vtkNew<vtkPNGReader> sheet;
  sheet->SetFileName((folder / "sheet.png").c_str());
  sheet->Update();
  vtkNew<vtkPNGReader> frame;
  frame->SetFileName((folder / "frame.png").c_str());
  frame->Update();
  ASSERT_EQ(sheet->GetOutput()->GetDimensions()[0], 804);
  ASSERT_EQ(sheet->GetOutput()->GetDimensions()[1], 804);
  // The second is on the right of the upper row; its upper left corner has its time.
  int others = 0;
  int corner = 0;
  for (int y = 0; y < 400; ++y)
  {
    for (int x = 0; x < 400; ++x)
    {
      const auto* a = static_cast<const unsigned char*>(sheet->GetOutput()->GetScalarPointer(404 + x, 404 + y, 0));
      const auto* b = static_cast<const unsigned char*>(frame->GetOutput()->GetScalarPointer(x, y, 0));
      const bool other = a[0] != b[0] || a[1] != b[1] || a[2] != b[2];
      (x < 120 && y > 340 ? corner : others) += other;
    }
  }
  EXPECT_EQ(others, 0);
  EXPECT_GT(corner, 20);
  const auto* empty = static_cast<const unsigned char*>(sheet->GetOutput()->GetScalarPointer(600, 200, 0));
  EXPECT_EQ(empty[0] + empty[1] + empty[2], 3 * 255);
}

TEST(Picture, CutsTheSeaAndLittleOfTheLand)
{
  tolerateTheDriver();
  if (!canDraw())
  {
    GTEST_SKIP() << "neither a display nor Xvfb to draw with";
  }
  const ScratchFolder folder("shore-section");
  const std::string picture = folder / "section.png";
  // Two thirds of the scene are land.
  ASSERT_EQ(runSwellray("render plane:slope=0.05,x0=-300,x1=150,y0=-10,y1=10 --style section --period 6 --direction 90 "
                        "--height 1.2 --size 800x600 -o " +
              picture),
    0);
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(picture.c_str());
  reader->Update();
  // Just under the upper edge of the section, where the bed is land.
  int land = 0;
  for (int x = 60; x < 780; ++x)
  {
    const auto* pixel = static_cast<const unsigned char*>(reader->GetOutput()->GetScalarPointer(x, 500, 0));
    land += pixel[0] > pixel[2] + 30;
  }
  EXPECT_GT(land, 0.02 * 720);
  EXPECT_LT(land, 0.12 * 720);
}
