#include "Observers.h"

#include "bathymetry/SeafloorReader.h"
#include "bathymetry/SeafloorReport.h"
#include "sim/BuiltinSeafloor.h"
#include "vtkSwellSeafloorReader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkStringArray.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>

#include <chrono>
#include <cmath>
#include <sstream>

namespace
{

// Node positions are the product of a whole number and a spacing.
constexpr double NodeTolerance = 1e-9;

std::string fieldText(vtkDataObject* data, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
  return array ? array->GetValue(0) : "";
}

double fieldNumber(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, 0) : std::nan("");
}

// 5 x 6 nodes, 10 m apart, south-west node at (1005, 2005), elevation -10 + column + row/10 counted from there.
std::string asciiGrid()
{
  std::string words = "ncols 5\nnrows 6\nxllcorner 1000\nyllcorner 2000\ncellsize 10\nNODATA_value -9999\n";
  for (int row = 5; row >= 0; --row)
  {
    for (int column = 0; column < 5; ++column)
    {
      words += std::to_string(-10.0 + column + 0.1 * row) + " ";
    }
    words += "\n";
  }
  return words;
}

struct Failure
{
  std::string words;
  unsigned long code = 0;
};

Failure failureOf(const std::string& name, const std::function<void(vtkSwellSeafloorReader*)>& set = {})
{
  vtkNew<vtkSwellSeafloorReader> reader;
  vtkNew<Listener> listener;
  listener->listenTo(reader);
  vtkNew<Listener> quiet;
  quiet->listenTo(reader->GetExecutive());
  reader->SetFileName(name.c_str());
  if (set)
  {
    set(reader);
  }
  reader->Update();
  EXPECT_EQ(listener->Errors.size(), 1u) << name;
  return { listener->Errors.empty() ? "" : listener->Errors.front(), reader->GetErrorCode() };
}

}

TEST(SeafloorReader, samplesABuiltinFormAndNamesIt)
{
  const char* spec = "shoal:kind=gauss,depth=20";
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName(spec);
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  EXPECT_EQ(fieldText(image, "SeafloorForm"), spec);
  EXPECT_EQ(fieldNumber(image, "OriginX"), 0.0);
  EXPECT_EQ(fieldNumber(image, "OriginY"), 0.0);
  EXPECT_EQ(image->GetFieldData()->GetAbstractArray("CRS"), nullptr);

  const auto form = swellray::makeBuiltinSeafloor(spec);
  double bounds[6];
  image->GetBounds(bounds);
  EXPECT_NEAR(bounds[0], form->bounds().low.x, NodeTolerance);
  EXPECT_NEAR(bounds[1], form->bounds().high.x, NodeTolerance);
  EXPECT_NEAR(bounds[2], form->bounds().low.y, NodeTolerance);
  EXPECT_NEAR(bounds[3], form->bounds().high.y, NodeTolerance);
  EXPECT_EQ(image->GetDimensions()[0], 500);
  vtkDataArray* elevation = image->GetPointData()->GetScalars();
  ASSERT_STREQ(elevation->GetName(), "Elevation");
  ASSERT_EQ(elevation->GetDataType(), VTK_DOUBLE);
  for (const vtkIdType i : { vtkIdType(0), vtkIdType(125250), vtkIdType(249999) })
  {
    const double* p = image->GetPoint(i);
    EXPECT_NEAR(elevation->GetComponent(i, 0), form->elevation({ p[0], p[1] }), NodeTolerance);
  }
  ASSERT_NE(reader->GetReport(), nullptr);
  EXPECT_EQ(reader->GetReport()->path, spec);
  EXPECT_EQ(reader->GetReport()->waterShare, 1.0);
  EXPECT_GT(reader->GetNumberOfReportLines(), 0);
}

TEST(SeafloorReader, cropsAFormAndKeepsItsName)
{
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName("plane");
  reader->UseCropOn();
  reader->SetCrop(100.0, -200.0, 300.0, 150.0);
  reader->Update();
  const double* bounds = reader->GetOutput()->GetBounds();
  EXPECT_NEAR(bounds[0], 100.0, NodeTolerance);
  EXPECT_NEAR(bounds[1], 300.0, NodeTolerance);
  EXPECT_NEAR(bounds[2], -200.0, NodeTolerance);
  EXPECT_NEAR(bounds[3], 150.0, NodeTolerance);
  EXPECT_EQ(fieldText(reader->GetOutput(), "SeafloorForm"), "plane");
}

TEST(SeafloorReader, aResampledOrSmoothedFormIsAGrid)
{
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName("plane");
  reader->SetResample(50.0);
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetSpacing()[0], 50.0);
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[0], 51);
  EXPECT_EQ(fieldText(reader->GetOutput(), "SeafloorForm"), "");
  reader->SetResample(0.0);
  reader->SetSmooth(20.0);
  reader->Update();
  EXPECT_EQ(fieldText(reader->GetOutput(), "SeafloorForm"), "");
}

TEST(SeafloorReader, readsAFileWithItsOrigin)
{
  const TemporaryFolder folder;
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName(folder.write("beach.asc", asciiGrid()).c_str());
  reader->SetCRS("EPSG:32618");
  reader->UpdateInformation();
  EXPECT_EQ(reader->GetOutputInformation(0)->Get(vtkDataObject::SPACING())[0], 10.0);
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  ASSERT_EQ(image->GetDimensions()[0], 5);
  ASSERT_EQ(image->GetDimensions()[1], 6);
  EXPECT_EQ(image->GetSpacing()[1], 10.0);
  // File coordinate = point + origin.
  EXPECT_NEAR(image->GetOrigin()[0] + fieldNumber(image, "OriginX"), 1005.0, NodeTolerance);
  EXPECT_NEAR(image->GetOrigin()[1] + fieldNumber(image, "OriginY"), 2005.0, NodeTolerance);
  EXPECT_THAT(fieldText(image, "CRS"), testing::HasSubstr("18N"));
  EXPECT_TRUE(std::isfinite(fieldNumber(image, "OriginLongitude")));
  EXPECT_TRUE(std::isfinite(fieldNumber(image, "OriginLatitude")));
  for (int row = 0; row < 6; ++row)
  {
    for (int column = 0; column < 5; ++column)
    {
      // Six decimals are in the file.
      EXPECT_NEAR(image->GetScalarComponentAsDouble(column, row, 0, 0), -10.0 + column + 0.1 * row, 1e-6);
    }
  }
}

TEST(SeafloorReader, readsAFileOnceUntilItOrAnOptionChanges)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("beach.asc", asciiGrid());
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName(path.c_str());
  const auto elevations = [&]
  {
    reader->Modified();
    reader->Update();
    return vtkSmartPointer<vtkDataArray>(reader->GetOutput()->GetPointData()->GetScalars());
  };
  const vtkSmartPointer<vtkDataArray> first = elevations();
  EXPECT_EQ(elevations(), first);
  reader->SetSmooth(10.0);
  const vtkSmartPointer<vtkDataArray> smoothed = elevations();
  EXPECT_NE(smoothed, first);
  std::filesystem::last_write_time(path, std::filesystem::last_write_time(path) + std::chrono::seconds(2));
  EXPECT_NE(elevations(), smoothed);
}

TEST(SeafloorReader, readsAgainWhereAFileChangesThatItsFileNames)
{
  const TemporaryFolder folder;
  const std::string row = "5 4 3 2 1\n";
  const std::string bottom = folder.write("a.bot", row + row + row + row);
  const std::string run =
    folder.write("a.swn", "INPGRID BOTTOM 0. 0. 0. 4 3 50. 50.\nREADINP BOTTOM 1. 'a.bot' 3 0 FREE\n");
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName(run.c_str());
  const auto elevations = [&]
  {
    reader->Modified();
    reader->Update();
    return vtkSmartPointer<vtkDataArray>(reader->GetOutput()->GetPointData()->GetScalars());
  };
  const vtkSmartPointer<vtkDataArray> first = elevations();
  EXPECT_EQ(elevations(), first);
  EXPECT_EQ(first->GetComponent(0, 0), -5.0);
  const auto date = std::filesystem::last_write_time(bottom);
  folder.write("a.bot", "9 8 7 6 5\n" + row + row + row);
  std::filesystem::last_write_time(bottom, date + std::chrono::seconds(2));
  EXPECT_EQ(elevations()->GetComponent(0, 0), -9.0);

  // A raster's coordinate reference system may lie beside it.
  const std::string raster = folder.write("b.asc", asciiGrid());
  const std::string beside = folder.write("b.prj",
    "GEOGCS[\"GCS_WGS_1984\",DATUM[\"D_WGS_1984\",SPHEROID[\"WGS_1984\",6378137.0,298.257223563]],"
    "PRIMEM[\"Greenwich\",0.0],UNIT[\"Degree\",0.0174532925199433]]");
  reader->SetFileName(raster.c_str());
  reader->SetCRS("local");
  const vtkSmartPointer<vtkDataArray> local = elevations();
  EXPECT_EQ(elevations(), local);
  std::filesystem::last_write_time(beside, std::filesystem::last_write_time(beside) + std::chrono::seconds(2));
  EXPECT_NE(elevations(), local);
}

TEST(SeafloorReader, imagesInFilesPlaceTheirPointsBackToAMillimetre)
{
  const TemporaryFolder folder;
  constexpr double Millimetre = 1e-3; // and less where the unit is a foot
  const struct
  {
    const char* crs;
    double west;
    double south;
    double size;
  } cases[] = { { "local", 100.1, 200.2, 10.0 }, { "EPSG:32618", 583960.12345, 4507523.65432, 10.0 },
    { "EPSG:2263", 981234.56789, 150123.45678, 30.0 }, { "EPSG:4326", -155.0712345678, 19.7412345678, 0.001 },
    { "EPSG:4326", 179.9961234567, -16.5, 0.001 } };
  for (const auto& one : cases)
  {
    std::ostringstream words;
    words.precision(15);
    words << "ncols 9\nnrows 9\nxllcenter " << one.west << "\nyllcenter " << one.south << "\ncellsize " << one.size
          << "\n";
    for (int i = 0; i < 81; ++i)
    {
      words << -5.0 - i << ' ';
    }
    const std::string path = folder.write("grid.asc", words.str());
    vtkNew<vtkSwellSeafloorReader> reader;
    reader->SetFileName(path.c_str());
    reader->SetCRS(one.crs);
    const std::string kept = folder.file("kept.vti");
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputConnection(reader->GetOutputPort());
    writer->SetFileName(kept.c_str());
    ASSERT_EQ(writer->Write(), 1) << one.crs;
    vtkNew<vtkXMLImageDataReader> back;
    back->SetFileName(kept.c_str());
    back->Update();
    vtkImageData* image = back->GetOutput();
    // From the numbers in the file alone.
    const swellray::Georeference place(fieldText(image, "CRS"),
      { fieldNumber(image, "OriginLongitude"), fieldNumber(image, "OriginLatitude") },
      { fieldNumber(image, "OriginX"), fieldNumber(image, "OriginY") });
    swellray::SeafloorOptions options;
    options.crs = one.crs;
    const swellray::Bathymetry read = swellray::readSeafloor(path, options);
    const bool degrees = place.kind() == swellray::GeoreferenceKind::Geographic;
    for (const vtkIdType i : { vtkIdType(0), vtkIdType(7), image->GetNumberOfPoints() - 1 })
    {
      double p[3];
      image->GetPoint(i, p);
      const glm::dvec2 found = place.toFile({ p[0], p[1] });
      const glm::dvec2 known = read.georeference.toFile({ p[0], p[1] });
      EXPECT_NEAR(found.x, known.x, degrees ? Millimetre / 1.2e5 : Millimetre) << one.crs;
      EXPECT_NEAR(found.y, known.y, degrees ? Millimetre / 1.2e5 : Millimetre) << one.crs;
      if (!degrees) // the nodes are the file's own
      {
        const auto column = static_cast<double>(i % 9);
        const auto row = static_cast<double>(i / 9);
        EXPECT_NEAR(found.x, one.west + column * one.size, Millimetre) << one.crs;
        EXPECT_NEAR(found.y, one.south + row * one.size, Millimetre) << one.crs;
      }
    }
  }
}

TEST(SeafloorReader, readsItsOwnImagesBack)
{
  const TemporaryFolder folder;
  vtkNew<vtkSwellSeafloorReader> first;
  first->SetFileName(folder.write("beach.asc", asciiGrid()).c_str());
  first->SetCRS("EPSG:32618");
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputConnection(first->GetOutputPort());
  writer->SetFileName(folder.file("beach.vti").c_str());
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkSwellSeafloorReader> second;
  second->SetFileName(folder.file("beach.vti").c_str());
  second->Update();
  vtkImageData* a = first->GetOutput();
  vtkImageData* b = second->GetOutput();
  ASSERT_EQ(b->GetNumberOfPoints(), a->GetNumberOfPoints());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(b->GetPointData()->GetScalars()->GetComponent(i, 0), a->GetPointData()->GetScalars()->GetComponent(i, 0));
  }
  for (const char* name : { "OriginX", "OriginY", "OriginLongitude", "OriginLatitude" })
  {
    EXPECT_NEAR(fieldNumber(b, name), fieldNumber(a, name), NodeTolerance) << name;
  }
  EXPECT_EQ(fieldText(b, "CRS"), fieldText(a, "CRS"));

  // Cropped by file coordinates: columns 1 to 4, rows 0 to 4.
  second->UseCropOn();
  second->SetCrop(1011.0, 2000.0, 1045.0, 2045.0);
  second->Update();
  EXPECT_EQ(second->GetOutput()->GetDimensions()[0], 4);
  EXPECT_EQ(second->GetOutput()->GetDimensions()[1], 5);
  EXPECT_EQ(second->GetOutput()->GetScalarComponentAsDouble(0, 0, 0, 0), a->GetScalarComponentAsDouble(1, 0, 0, 0));
}

TEST(SeafloorReader, saysWhatIsWrongOnce)
{
  const TemporaryFolder folder;
  const Failure missing = failureOf(folder.file("nowhere.nc"));
  EXPECT_THAT(missing.words, testing::HasSubstr("nowhere.nc"));
  EXPECT_EQ(missing.code, vtkErrorCode::FileNotFoundError);
  const Failure noImage = failureOf(folder.file("nowhere.vti"));
  EXPECT_THAT(noImage.words, testing::HasSubstr("nowhere.vti"));
  EXPECT_EQ(noImage.code, vtkErrorCode::FileNotFoundError);
  EXPECT_EQ(failureOf("").code, vtkErrorCode::NoFileNameError);
  const Failure words = failureOf(folder.write("words.tif", "this is no picture\n"));
  EXPECT_THAT(words.words, testing::HasSubstr("words.tif"));
  EXPECT_EQ(words.code, vtkErrorCode::FileFormatError);
  EXPECT_EQ(failureOf(folder.write("words.vti", "this is no picture\n")).code, vtkErrorCode::FileFormatError);
  const Failure key = failureOf("plane:sloop=3");
  EXPECT_THAT(key.words, testing::HasSubstr("sloop"));
  EXPECT_EQ(key.code, vtkErrorCode::UserError);
  EXPECT_THAT(failureOf("plane", [](vtkSwellSeafloorReader* r) { r->SetPositiveToDown(); }).words,
    testing::HasSubstr("built-in form"));
  EXPECT_THAT(
    failureOf("plane", [](vtkSwellSeafloorReader* r) { r->SetResample(1e-3); }).words, testing::HasSubstr("resample"));
  EXPECT_THAT(failureOf("plane", [](vtkSwellSeafloorReader* r) { r->SetWaterLevel(-1000.0); }).words,
    testing::HasSubstr("no water"));
  EXPECT_THAT(failureOf("plane",
                [](vtkSwellSeafloorReader* r)
                {
                  r->UseCropOn();
                  r->SetCrop(1e6, 1e6, 2e6, 2e6);
                })
                .words,
    testing::HasSubstr("crop"));
  EXPECT_THAT(
    failureOf(folder.write("beach.asc", asciiGrid()), [](vtkSwellSeafloorReader* r) { r->SetSmooth(-1.0); }).words,
    testing::HasSubstr("smooth"));
}

TEST(SeafloorReader, recoversFromAFailure)
{
  vtkNew<vtkSwellSeafloorReader> reader;
  vtkNew<Listener> listener;
  listener->listenTo(reader);
  vtkNew<Listener> quiet;
  quiet->listenTo(reader->GetExecutive());
  reader->SetFileName("plane:slope=-1");
  reader->Update();
  EXPECT_EQ(listener->Errors.size(), 1u);
  EXPECT_EQ(reader->GetReport(), nullptr);
  reader->SetFileName("plane:slope=0.05");
  reader->Update();
  EXPECT_EQ(listener->Errors.size(), 1u);
  EXPECT_EQ(reader->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_GT(reader->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(SeafloorReader, readsAgainAfterAnAbort)
{
  const TemporaryFolder folder;
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName(folder.write("beach.asc", asciiGrid()).c_str());
  vtkNew<Listener> listener;
  listener->AbortAt = 0.3;
  listener->listenTo(reader);
  vtkNew<Listener> quiet;
  quiet->listenTo(reader->GetExecutive());
  reader->Update();
  ASSERT_EQ(listener->Errors.size(), 1u);
  EXPECT_THAT(listener->Errors.front(), testing::HasSubstr("cancelled"));
  listener->AbortAt = -1.0;
  reader->Modified();
  reader->Update();
  EXPECT_EQ(listener->Errors.size(), 1u);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 30);
}
