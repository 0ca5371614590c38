#include "Program.h"

#include <gtest/gtest.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <string>

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
