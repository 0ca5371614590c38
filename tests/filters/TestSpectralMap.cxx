#include "Observers.h"

#include "bathymetry/TransferFile.h"
#include "sim/Angles.h"
#include "sim/DirectionalSpectrum.h"
#include "sim/Dispersion.h"
#include "sim/SeaState.h"
#include "vtkSwellSeafloorReader.h"
#include "vtkSwellSpectralMap.h"

#include <gtest/gtest.h>

#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <cmath>
#include <filesystem>

namespace
{

// Of a sea 2 degrees wide against waves of one direction: the bins are 2 degrees wide too.
constexpr double NarrowHeight = 3e-3;
constexpr double NarrowDirection = 0.1; // degrees

vtkNew<vtkPolyData> pointsAt(const std::vector<std::array<double, 2>>& places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& place : places)
  {
    points->InsertNextPoint(place[0], place[1], 0.0);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  return data;
}

struct Scene
{
  Scene()
  {
    this->Reader->SetFileName("plane:slope=0.02,x0=-100,x1=4000,y0=-20000,y1=20000");
    this->Map->SetInputData(0, this->Stations);
    this->Map->SetSeafloorConnection(this->Reader->GetOutputPort());
    this->Map->SetSignificantHeight(1.0);
    this->Map->SetPeakPeriod(10.0);
    this->Map->SetDirectionFrom(60.0);
    this->Map->SetBreakingRuleToNone();
  }

  double value(const char* name, vtkIdType i = 0)
  {
    return this->Map->GetOutput()->GetPointData()->GetArray(name)->GetComponent(i, 0);
  }

  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellSpectralMap> Map;
  vtkNew<vtkPolyData> Stations = pointsAt({ { 400.0, 0.0 }, { 50.0, 0.0 }, { -50.0, 0.0 } });
};

TEST(SpectralMap, ANarrowSeaFollowsSnell)
{
  Scene scene;
  scene.Map->SetSpread(2.0);
  scene.Map->SetPeakedness(20.0);
  scene.Map->SetNumberOfDirections(180);
  scene.Map->SetNumberOfFrequencies(40);
  scene.Map->KeepSpectraOn();
  scene.Map->Update();
  // Snell's law and the flux of energy, frequency by frequency of the sea offshore.
  const double depth = 8.0;
  const double angle0 = swellray::radians(30.0);
  const auto sea = swellray::FrequencySpectrum::jonswap(1.0, 10.0, 20.0);
  const auto offshore = swellray::DirectionalSpectrum::sample(swellray::spectralGridOf(sea, 40, 72), sea,
    swellray::DirectionalSpreading::cosinePower(swellray::radians(2.0)), swellray::headingFromNautical(60.0));
  const std::vector<double> df = offshore.grid.frequencyWeights();
  const std::vector<double> density = offshore.overFrequency();
  double m0 = 0.0;
  glm::dvec2 mean(0.0);
  for (std::size_t i = 0; i < df.size(); ++i)
  {
    const double omega = 2.0 * swellray::Pi * offshore.grid.frequencies[i];
    const double k0 = omega * omega / 9.81;
    const double k = swellray::solveWavenumber(omega, depth);
    const double angle = std::asin(k0 / k * std::sin(angle0));
    const double share = density[i] * df[i] * 0.5 * omega / k0 / swellray::waveSpeeds(k, depth).groupSpeed *
      std::cos(angle0) / std::cos(angle);
    m0 += share;
    mean += share * glm::dvec2(std::cos(angle), std::sin(angle));
  }
  const double height = 4.0 * std::sqrt(m0);
  const double angle = std::atan2(mean.y, mean.x);
  EXPECT_NEAR(scene.value("Depth"), depth, 1e-6);
  EXPECT_NEAR(scene.value("SignificantWaveHeight"), height, NarrowHeight * height);
  EXPECT_NEAR(scene.value("MeanDirectionFrom"), 90.0 - swellray::degrees(angle), NarrowDirection);
  EXPECT_NEAR(scene.value("PeakPeriod"), 10.0, 0.2);
  EXPECT_EQ(scene.value("Breaking"), 0.0);
  EXPECT_TRUE(std::isnan(scene.value("SignificantWaveHeight", 2))); // on land
  ASSERT_EQ(scene.Map->GetSpectra().size(), 3u);
  EXPECT_NEAR(
    swellray::seaParameters(scene.Map->GetSpectra()[0]).significantHeight, scene.value("SignificantWaveHeight"), 1e-12);
  EXPECT_TRUE(scene.Map->GetSpectra()[2].density.empty());
  vtkFieldData* fields = scene.Map->GetOutput()->GetFieldData();
  EXPECT_NEAR(fields->GetArray("OffshoreSignificantWaveHeight")->GetComponent(0, 0), 1.0, 1e-4);
  EXPECT_NE(fields->GetArray("OriginX"), nullptr);
}

TEST(SpectralMap, TheDepthLimitsTheSea)
{
  Scene scene;
  scene.Map->SetSignificantHeight(3.0);
  scene.Map->SetBreakingRuleToGamma();
  scene.Map->SetGamma(0.5);
  scene.Map->Update();
  EXPECT_NEAR(scene.value("SignificantWaveHeight", 1), 0.5, 1e-9); // 1 m deep
  EXPECT_EQ(scene.value("Breaking", 1), 1.0);
  EXPECT_EQ(scene.value("Breaking", 0), 0.0);
  const double before = scene.value("SignificantWaveHeight", 0);
  scene.Map->SetFriction(0.038);
  scene.Map->Update();
  EXPECT_LT(scene.value("SignificantWaveHeight", 0), before);
}

TEST(SpectralMap, TheSeafloorsOwnNodesNeedNoSecondInput)
{
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName("plane:slope=0.02,x0=-100,x1=400,y0=-200,y1=200");
  reader->SetResample(100.0);
  vtkNew<vtkSwellSpectralMap> map;
  map->SetInputConnection(0, reader->GetOutputPort());
  map->SetNumberOfFrequencies(3);
  map->SetNumberOfDirections(12);
  map->SetDirectionFrom(90.0);
  map->Update();
  vtkImageData* output = vtkImageData::SafeDownCast(map->GetOutput());
  ASSERT_NE(output, nullptr);
  EXPECT_EQ(output->GetNumberOfPoints(), reader->GetOutput()->GetNumberOfPoints());
  EXPECT_NE(output->GetPointData()->GetArray("Elevation"), nullptr);
  EXPECT_NE(output->GetPointData()->GetArray("SignificantWaveHeight"), nullptr);
}

TEST(SpectralMap, IsTheSameForAnyNumberOfThreads)
{
  Scene scene;
  vtkSMPTools::Initialize(1);
  scene.Map->Update();
  const double alone = scene.value("SignificantWaveHeight");
  vtkSMPTools::Initialize(2);
  scene.Map->Modified();
  scene.Map->Update();
  EXPECT_EQ(scene.value("SignificantWaveHeight"), alone);
  vtkSMPTools::Initialize();
}

TEST(SpectralMap, KeepsItsRaysInAFile)
{
  const std::string file = (std::filesystem::path(testing::TempDir()) / "spectral_map.nc").string();
  std::filesystem::remove(file);
  Scene scene;
  scene.Map->Update();
  const double alone = scene.value("SignificantWaveHeight", 1);
  scene.Map->SetTransferFileName(file.c_str());
  scene.Map->Update();
  EXPECT_EQ(scene.value("SignificantWaveHeight", 1), alone);
  EXPECT_EQ(scene.Map->GetTransferTable().places.size(), 3u);
  ASSERT_TRUE(std::filesystem::exists(file));

  // Another sea along the same rays, and a place more.
  Scene other;
  other.Map->SetInputData(0, pointsAt({ { 50.0, 0.0 }, { 700.0, 10.0 } }));
  other.Map->SetTransferFileName(file.c_str());
  other.Map->SetSignificantHeight(2.0);
  other.Map->Update();
  // Read back, directions have been degrees: they agree to rounding.
  constexpr double ReadBack = 1e-9;
  EXPECT_NEAR(other.value("SignificantWaveHeight", 0), 2.0 * alone, ReadBack);
  EXPECT_EQ(swellray::readTransferTable(file).places.size(), 4u);

  // The bed counts by its values.
  vtkNew<Listener> listener;
  listener->listenTo(other.Map);
  listener->listenTo(other.Map->GetExecutive());
  other.Reader->SetFileName("plane:slope=0.021,x0=-100,x1=4000,y0=-20000,y1=20000");
  other.Map->Update();
  ASSERT_FALSE(listener->Errors.empty());
  EXPECT_NE(listener->Errors.front().find("belongs to another scene: it has seafloor"), std::string::npos);
}

TEST(SpectralMap, AnAbortKeepsWhatIsTraced)
{
  const std::string file = (std::filesystem::path(testing::TempDir()) / "aborted.nc").string();
  std::filesystem::remove(file);
  Scene scene;
  std::vector<std::array<double, 2>> places;
  for (int i = 0; i < 200; ++i)
  {
    places.push_back({ 20.0 + i, 0.0 });
  }
  scene.Map->SetInputData(0, pointsAt(places));
  scene.Map->SetNumberOfFrequencies(3);
  scene.Map->SetNumberOfDirections(8);
  scene.Map->SetTransferFileName(file.c_str());
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* filter = static_cast<vtkAlgorithm*>(caller);
      filter->SetAbortExecute(filter->GetProgress() > 0.5);
    });
  const unsigned long tag = scene.Map->AddObserver(vtkCommand::ProgressEvent, stop);
  scene.Map->Update();
  EXPECT_EQ(scene.Map->GetOutput()->GetNumberOfPoints(), 0);
  const std::size_t kept = swellray::readTransferTable(file).places.size();
  EXPECT_GT(kept, 0u);
  EXPECT_LT(kept, 200u);
  scene.Map->RemoveObserver(tag);
  scene.Map->Modified();
  scene.Map->Update();
  EXPECT_EQ(scene.Map->GetOutput()->GetNumberOfPoints(), 200);
  EXPECT_EQ(swellray::readTransferTable(file).places.size(), 200u);
}

TEST(SpectralMap, SaysWhatIsWrong)
{
  Scene scene;
  vtkNew<Listener> listener;
  listener->listenTo(scene.Map);
  listener->listenTo(scene.Map->GetExecutive());
  scene.Map->SetSpread(0.0);
  scene.Map->Update();
  ASSERT_FALSE(listener->Errors.empty());
  EXPECT_NE(listener->Errors.front().find("spread"), std::string::npos);
  listener->Errors.clear();
  scene.Map->SetSpread(20.0);
  scene.Map->SetBoundaryFileName("nowhere.bnd");
  scene.Map->Update();
  ASSERT_FALSE(listener->Errors.empty());
  EXPECT_NE(listener->Errors.front().find("nowhere.bnd"), std::string::npos);
  EXPECT_EQ(scene.Map->GetOutput()->GetNumberOfPoints(), 0);
}

}
