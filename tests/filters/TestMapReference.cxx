// A map against the exact wave field of a circular shoal, where its table lies beside the data folder.
#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"
#include "vtkSwellStations.h"
#include "vtkSwellWaveHeight.h"

#include <gtest/gtest.h>

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{

// On each transect, cusp and caustics included, in incident heights: what a plain sum of rays has where there is no caustic.
constexpr double RootMeanSquare = 0.08;

struct Sample
{
  int transect;
  double x;
  double y;
  double height;
};

// Columns transect, x, y, h, phi (re, im, abs), eta (re, im, abs).
std::vector<Sample> readSamples(const std::filesystem::path& file)
{
  std::vector<Sample> samples;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
  {
    std::vector<double> row;
    std::stringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');)
    {
      char* end = nullptr;
      row.push_back(std::strtod(cell.c_str(), &end));
      if (end == cell.c_str())
      {
        row.clear();
        break;
      }
    }
    if (row.size() == 10)
    {
      samples.push_back({ static_cast<int>(row[0]), row[1], row[2], row[9] });
    }
  }
  return samples;
}

TEST(MapReference, CoherentFieldOfAShoal)
{
  const char* set = std::getenv("SWELLRAY_DATA");
  const std::filesystem::path file =
    std::filesystem::path(set ? set : SWELLRAY_DATA_DEFAULT) / ".." / "reference" / "c7b_shoal_poly3_wave.csv";
  if (!std::filesystem::exists(file))
  {
    GTEST_SKIP() << "no reference table " << file;
  }
  const std::vector<Sample> samples = readSamples(file);
  ASSERT_GT(samples.size(), 500u);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Sample& sample : samples)
  {
    points->InsertNextPoint(sample.x, sample.y, 0.0);
  }

  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName("shoal:kind=poly3,depth=15,height=10.5,radius=250,x0=-1000,x1=1000,y0=-1000,y1=1000");
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputConnection(reader->GetOutputPort());
  tracer->SetPeriod(8.0);
  tracer->SetDirectionFrom(270.0);
  tracer->SetWaveHeight(1.0);
  tracer->SetOffshoreDepth(15.0);
  tracer->SetSpacing(5.0);
  vtkNew<vtkSwellWaveHeight> height;
  height->SetInputConnection(tracer->GetOutputPort());
  height->SetBreakingRuleToNone();
  height->SetAmplitudeRuleToTube();
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkSwellStations> stations;
  stations->SetInputConnection(0, height->GetOutputPort());
  stations->SetSeafloorConnection(reader->GetOutputPort());
  stations->SetInputData(2, places);
  stations->SetCombineRuleToPhase();
  stations->Update();

  vtkDataArray* found = stations->GetOutput()->GetPointData()->GetArray("WaveHeight");
  ASSERT_TRUE(found);
  std::map<int, std::pair<double, int>> squares; // by transect
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const double error = found->GetComponent(static_cast<vtkIdType>(i), 0) - samples[i].height;
    squares[samples[i].transect].first += error * error;
    ++squares[samples[i].transect].second;
  }
  ASSERT_EQ(squares.size(), 5u);
  for (const auto& [transect, sum] : squares)
  {
    EXPECT_LT(std::sqrt(sum.first / sum.second), RootMeanSquare) << "transect " << transect;
  }
}

}
