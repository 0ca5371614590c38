#include "Program.h"

#include <gtest/gtest.h>

#include <vtkImageData.h>
#include <vtkImageExtractComponents.h>
#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace
{

// Pictures are compared by the means of squares of so many pixels a side: drivers put edges and type a pixel apart.
constexpr int Square = 8;

// Levels of 255. An edge from black to white that lies a pixel aside changes the mean of a square by an eighth of that.
constexpr int SameSquare = 32;
constexpr double OtherSquares = 0.005; // share of all
constexpr double SameMean = 1.5;       // over the whole picture

struct Baseline
{
  const char* name;
  const char* call;    // that makes the picture
  const char* another; // one whose picture must not pass for it
};

std::ostream& operator<<(std::ostream& out, const Baseline& baseline)
{
  return out << baseline.name;
}

vtkSmartPointer<vtkImageData> read(const std::string& path)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  vtkNew<vtkImageExtractComponents> colors;
  colors->SetInputConnection(reader->GetOutputPort());
  colors->SetComponents(0, 1, 2);
  colors->Update();
  return colors->GetOutput();
}

vtkSmartPointer<vtkImageData> squaresOf(const std::string& path)
{
  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputData(read(path));
  shrink->SetShrinkFactors(Square, Square, 1);
  shrink->MeanOn();
  shrink->Update();
  return shrink->GetOutput();
}

struct Difference
{
  double otherSquares = 1.0; // share
  double mean = 255.0;       // levels

  bool isSame() const { return this->otherSquares <= OtherSquares && this->mean <= SameMean; }
};

Difference compare(vtkImageData* a, vtkImageData* b)
{
  Difference difference;
  const int* size = a->GetDimensions();
  if (!std::equal(size, size + 3, b->GetDimensions()))
  {
    return difference;
  }
  int others = 0;
  double sum = 0.0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const auto* p = static_cast<unsigned char*>(a->GetScalarPointer(x, y, 0));
      const auto* q = static_cast<unsigned char*>(b->GetScalarPointer(x, y, 0));
      int most = 0;
      for (int i = 0; i < 3; ++i)
      {
        most = std::max(most, std::abs(p[i] - q[i]));
        sum += std::abs(p[i] - q[i]) / 3.0;
      }
      others += most > SameSquare ? 1 : 0;
    }
  }
  difference.otherSquares = static_cast<double>(others) / (size[0] * size[1]);
  difference.mean = sum / (size[0] * size[1]);
  return difference;
}

class Baselines : public testing::TestWithParam<Baseline>
{
};

// Why nothing can be drawn; empty where it can.
std::string hindrance()
{
  if (std::getenv("ASAN_OPTIONS") || std::getenv("TSAN_OPTIONS"))
  {
    return "sanitizers see into the software driver of OpenGL";
  }
  const char* display = std::getenv("DISPLAY");
  const bool canDraw = (display && *display) || std::system("command -v Xvfb > /dev/null 2>&1") == 0;
  return canDraw ? "" : "neither a display nor Xvfb to draw with";
}

std::string pathOf(const char* name)
{
  return std::string(SWELLRAY_SOURCE_DIR) + "/tests/baselines/" + name + ".png";
}

TEST_P(Baselines, AreWhatIsDrawn)
{
  if (!hindrance().empty())
  {
    GTEST_SKIP() << hindrance();
  }
  const Baseline& baseline = this->GetParam();
  const ScratchFolder folder(std::string("baseline-") + baseline.name);
  const std::string picture = folder / "picture.png";
  const std::string kept = pathOf(baseline.name);
  ASSERT_EQ(runSwellray(std::string(baseline.call) + " -o " + picture), 0);
  const auto drawn = squaresOf(picture);
  if (std::getenv("SWELLRAY_UPDATE_BASELINES"))
  {
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(drawn);
    writer->SetFileName(kept.c_str());
    writer->Write();
  }
  ASSERT_TRUE(std::filesystem::exists(kept)) << "make it with SWELLRAY_UPDATE_BASELINES=1, and look at it";
  const auto expected = read(kept);
  const Difference difference = compare(drawn, expected);
  EXPECT_TRUE(difference.isSame()) << "other squares: " << difference.otherSquares << ", mean: " << difference.mean
                                   << " levels; if that is meant, run with SWELLRAY_UPDATE_BASELINES=1 and look at "
                                   << kept;

  ASSERT_EQ(runSwellray(std::string(baseline.another) + " -o " + picture), 0);
  const Difference other = compare(squaresOf(picture), expected);
  EXPECT_FALSE(other.isSame()) << "other squares: " << other.otherSquares << ", mean: " << other.mean;
  RecordProperty("difference", std::to_string(difference.mean) + " " + std::to_string(difference.otherSquares));
  RecordProperty("another", std::to_string(other.mean) + " " + std::to_string(other.otherSquares));
}

constexpr Baseline Kept[] = {
  { "chart", "render island --period 8 --direction 270 --height 1 --crests auto --size 640x480",
    "render island --period 8 --direction 255 --height 1 --crests auto --size 640x480" },
  { "aerial", "render bay --style scene --camera aerial --period 3 --direction 90 --height 0.4 --time 1 --size 640x400",
    "render bay --style scene --camera aerial --period 3 --direction 90 --height 0.4 --time 2.5 --size 640x400" },
  { "shore", "render babbage --style scene --period 6 --direction 0 --height 1.5 --time 1 --sun 60,12 --size 640x400",
    "render babbage --style scene --period 6 --direction 0 --height 1.5 --time 1 --sun 300,12 --size 640x400" },
};

INSTANTIATE_TEST_SUITE_P(
  Pictures, Baselines, testing::ValuesIn(Kept), [](const auto& each) { return each.param.name; });

TEST(Baselines, ShowTheSameWaterSampledByTheScreen)
{
  if (!hindrance().empty())
  {
    GTEST_SKIP() << hindrance();
  }
  // Edges of the sea and of foam are where samples are, 2 pixels apart; half a period later there are 6 levels.
  constexpr double SampledMean = 2.5;
  const ScratchFolder folder("screen");
  const std::string picture = folder / "picture.png";
  ASSERT_EQ(runSwellray(std::string(Kept[1].call) + " --detail screen -o " + picture), 0);
  EXPECT_LT(compare(squaresOf(picture), read(pathOf("aerial"))).mean, SampledMean);
}

}
