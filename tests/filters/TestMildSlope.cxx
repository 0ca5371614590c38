#include "vtkSwellMildSlope.h"

#include "Observers.h"
#include "vtkSwellSeafloorReader.h"

#include <gtest/gtest.h>

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkStringArray.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace
{

/** The elliptic shoal, coarse enough to be quick. */
class MildSlopeFilter : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Reader->SetFileName("berkhoff:x0=-8,x1=8,y0=-6,y1=6");
    this->Waves->SetInputConnection(this->Reader->GetOutputPort());
    this->Waves->SetPeriod(1.0);
    this->Waves->SetDirectionFrom(270.0);
    this->Waves->SetWaveHeight(0.0464);
    this->Waves->SetOffshoreDepth(0.45);
    this->Waves->SetNodeSpacing(0.14);
    this->Waves->SetSpacing(0.5);
    this->Waves->SetBreakingRule(0);
    this->Heard->listenTo(this->Waves);
  }

  vtkImageData* map() { return vtkImageData::SafeDownCast(this->Waves->GetOutputDataObject(0)); }
  vtkDataArray* array(const char* name) { return this->map()->GetPointData()->GetArray(name); }
  double field(const char* name)
  {
    vtkDataArray* value = this->map()->GetFieldData()->GetArray(name);
    return value ? value->GetComponent(0, 0) : std::nan("");
  }

  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellMildSlope> Waves;
  vtkNew<Listener> Heard;
};

TEST_F(MildSlopeFilter, MakesAMapWithItsArrays)
{
  this->Waves->Update();
  ASSERT_TRUE(this->Heard->Errors.empty()) << this->Heard->Errors.front();
  EXPECT_EQ(this->map()->GetDimensions()[0], 33);
  EXPECT_EQ(this->map()->GetDimensions()[1], 25);
  for (const char* name :
    { "Elevation", "Depth", "WaveHeight", "DirectionFrom", "Wavelength", "WavePhase", "Breaking" })
  {
    ASSERT_TRUE(this->array(name)) << name;
    EXPECT_EQ(this->array(name)->GetNumberOfTuples(), 33 * 25);
  }
  EXPECT_STREQ(this->map()->GetPointData()->GetScalars()->GetName(), "WaveHeight");
  // The shoal focuses some 4 m behind its centre to more than twice the height.
  double range[2];
  this->array("WaveHeight")->GetRange(range);
  EXPECT_GT(range[1], 2.0 * 0.0464);
  EXPECT_LT(range[1], 3.0 * 0.0464);
  EXPECT_EQ(this->field("Solutions"), 1.0);
  EXPECT_LT(this->field("Residual"), 1e-9);
  EXPECT_EQ(this->field("Period"), 1.0);
  EXPECT_GT(this->field("MeshColumns"), 114.0);
  EXPECT_GT(this->Heard->Progress.size(), 3u);
}

TEST_F(MildSlopeFilter, PointsHaveTheValuesOfTheMap)
{
  vtkNew<vtkPoints> places;
  places->InsertNextPoint(4.0, 0.5, 0.0);
  places->InsertNextPoint(-3.0, 2.0, 7.0);
  places->InsertNextPoint(30.0, 0.0, 0.0);
  vtkNew<vtkPolyData> stations;
  stations->SetPoints(places);
  this->Waves->SetInputData(1, stations);
  this->Waves->Update();
  auto* points = vtkPolyData::SafeDownCast(this->Waves->GetOutputDataObject(1));
  ASSERT_EQ(points->GetNumberOfPoints(), 3);
  EXPECT_EQ(points->GetNumberOfVerts(), 3);
  for (const char* name : { "WaveHeight", "DirectionFrom", "WavePhase", "Depth" })
  {
    vtkDataArray* values = points->GetPointData()->GetArray(name);
    ASSERT_TRUE(values) << name;
    for (vtkIdType i = 0; i < 2; ++i)
    {
      const vtkIdType node = this->map()->FindPoint(points->GetPoint(i)[0], points->GetPoint(i)[1], 0.0);
      EXPECT_NEAR(values->GetComponent(i, 0), this->array(name)->GetComponent(node, 0), 1e-9) << name;
    }
    EXPECT_TRUE(std::isnan(values->GetComponent(2, 0)));
  }
}

TEST_F(MildSlopeFilter, IsTheSameOnAnyNumberOfThreads)
{
  std::vector<double> heights[2];
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::Initialize(threads);
    this->Waves->Modified();
    this->Waves->Update();
    for (vtkIdType i = 0; i < this->map()->GetNumberOfPoints(); ++i)
    {
      heights[threads == 1 ? 0 : 1].push_back(this->array("WaveHeight")->GetComponent(i, 0));
    }
  }
  vtkSMPTools::Initialize(0);
  EXPECT_EQ(heights[0], heights[1]);
}

TEST_F(MildSlopeFilter, SaysWhatItWillTakeWithoutDoingIt)
{
  this->Waves->PlanOnlyOn();
  this->Waves->Update();
  EXPECT_TRUE(this->Heard->Errors.empty());
  EXPECT_FALSE(this->map()->GetPointData()->HasArray("WaveHeight"));
  EXPECT_GT(this->field("Memory"), 1e6);
  EXPECT_LT(this->field("Memory"), 1e9);
  EXPECT_GT(this->field("SolutionSeconds"), 0.0);
  EXPECT_NEAR(this->field("NodesPerWave"), 7.34, 0.05);
}

TEST_F(MildSlopeFilter, StopsWhereAborted)
{
  this->Heard->AbortAt = 0.2;
  this->Waves->Update();
  EXPECT_EQ(this->map()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(this->Heard->Errors.empty());
}

TEST_F(MildSlopeFilter, RefusesInOneLine)
{
  this->Waves->SetMemoryLimit(1e6);
  this->Waves->Update();
  ASSERT_EQ(this->Heard->Errors.size(), 1u);
  EXPECT_NE(this->Heard->Errors[0].find("more than the 0.001 GB that it may take"), std::string::npos)
    << this->Heard->Errors[0];
  EXPECT_EQ(this->map()->GetNumberOfPoints(), 0);
  this->Waves->SetMemoryLimit(0.0);
  this->Waves->SetCoastReflection(2.0);
  this->Waves->Update();
  ASSERT_EQ(this->Heard->Errors.size(), 2u);
  EXPECT_NE(this->Heard->Errors[1].find("within 0 to 1, not 2"), std::string::npos);
}

TEST(MildSlopeSites, heightsFallSmoothlyBehindTheBreakwaterOfHilo)
{
  const char* set = std::getenv("SWELLRAY_DATA");
  const std::filesystem::path sites = std::filesystem::path(set ? set : SWELLRAY_DATA_DEFAULT) / "sites";
  const std::string seafloor = sites / "hilo_bay_hawaii/hilo_bay_1_3s_epsg4326.tif";
  const std::string land = sites / "_shorelines/hilo_land_polygons.geojson";
  if (!std::filesystem::exists(seafloor) || !std::filesystem::exists(land))
  {
    GTEST_SKIP() << "no " << seafloor << " or " << land;
  }
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName(seafloor.c_str());
  reader->SetUseCrop(true);
  reader->SetCrop(-155.0887, 19.7255, -155.045, 19.752);
  // The wall is land in the grid, too: it casts its shadow with and without the obstacle. Bounds are by what was computed
  // once, with room: a lee without waves, a step at the shadow's edge or a wave that goes straight through do not pass.
  // From the open water past the head of the breakwater into its shadow, 13 m a point: some 5 a wavelength.
  vtkNew<vtkPolyData> line;
  vtkNew<vtkPoints> points;
  for (double x = -1750.0; x <= -650.0; x += 13.0)
  {
    points->InsertNextPoint(x, -604.0, 0.0);
  }
  line->SetPoints(points);
  vtkNew<vtkSwellMildSlope> waves;
  waves->SetInputConnection(0, reader->GetOutputPort());
  waves->SetInputData(1, line);
  waves->SetPeriod(14.0);
  waves->SetDirectionFrom(20.0);
  waves->SetWaveHeight(1.0);
  waves->SetBreakingRule(0);
  waves->SetMinimumDepth(3.0);
  waves->SetObstacles(land.c_str());
  waves->SetReflection(0.3);
  waves->Update();
  vtkDataArray* heights =
    vtkDataSet::SafeDownCast(waves->GetOutputDataObject(1))->GetPointData()->GetArray("WaveHeight");
  ASSERT_EQ(heights->GetNumberOfTuples(), points->GetNumberOfPoints());
  const vtkIdType last = heights->GetNumberOfTuples() - 1;
  EXPECT_GT(heights->GetComponent(0, 0), 0.9);
  EXPECT_LT(heights->GetComponent(last, 0), 0.25);
  for (vtkIdType i = 0; i <= last; ++i)
  {
    ASSERT_TRUE(std::isfinite(heights->GetComponent(i, 0))) << i;
    // Rays alone step from 1 to nothing from one point to the next.
    EXPECT_TRUE(i == 0 || std::abs(heights->GetComponent(i, 0) - heights->GetComponent(i - 1, 0)) < 0.15) << i;
    // The mean over 15 points, some 200 m, only falls, but for ripples of reflected waves.
    const auto mean = [&](vtkIdType begin)
    {
      double sum = 0.0;
      for (vtkIdType j = begin; j < begin + 15; ++j)
      {
        sum += heights->GetComponent(j, 0) / 15.0;
      }
      return sum;
    };
    EXPECT_TRUE(i + 30 > last || mean(i + 15) < mean(i) + 0.02) << i;
  }
}

}
