#include "vtkSwellSeafloorReader.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "GeoreferenceField.h"
#include "RayArrays.h"
#include "SeafloorField.h"
#include "SeafloorSource.h"

#include <vtkDataObject.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSwellSeafloorReader);

/** What was read last, and from what. */
struct vtkSwellSeafloorReader::Reading
{
  std::string source; // file and the options
  std::string dates;  // of the file and of those that it names
  vtkSmartPointer<vtkImageData> image;
  swellray::SeafloorReport report;
};

namespace
{

std::string describeSource(const std::string& name, const swellray::SeafloorOptions& options)
{
  std::ostringstream words;
  words << std::hexfloat << name << '\n';
  const std::array<double, 4> crop = options.crop.value_or(std::array<double, 4>{});
  words << '\n' << options.crop.has_value();
  for (const double side : crop)
  {
    words << ' ' << side;
  }
  words << '\n'
        << options.resample.value_or(0.0) << ' ' << options.smooth << ' ' << options.waterLevel << ' '
        << static_cast<int>(options.positive) << ' ' << static_cast<int>(options.earth) << ' '
        << options.nodata.has_value() << ' ' << options.nodata.value_or(0.0) << ' ' << options.maxGap.value_or(-1.0)
        << ' ' << options.dropOutliers << ' ' << options.crossValidate << '\n'
        << options.crs << '\n'
        << options.variable;
  return words.str();
}

// When a file, and those that were read with it, were last written; a file that is gone has no date.
std::string describeDates(const std::string& name, const swellray::SeafloorReport& report)
{
  std::ostringstream words;
  std::vector<std::string> files = report.files;
  files.push_back(name);
  for (const std::string& file : files)
  {
    std::error_code none;
    const auto date = std::filesystem::last_write_time(file, none);
    words << file << ' ' << (none ? 0 : date.time_since_epoch().count()) << '\n';
  }
  return words.str();
}

vtkSmartPointer<vtkImageData> imageOf(const swellray::SeafloorScene& scene)
{
  const swellray::ElevationGrid& grid = scene.bathymetry.grid;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(grid.columns), static_cast<int>(grid.rows), 1);
  image->SetOrigin(grid.origin.x, grid.origin.y, 0.0);
  image->SetSpacing(grid.spacing.x, grid.spacing.y, std::min(grid.spacing.x, grid.spacing.y));
  double* elevation =
    swellray::addArray<vtkDoubleArray>(image->GetPointData(), "Elevation", image->GetNumberOfPoints());
  std::copy(grid.elevation.begin(), grid.elevation.end(), elevation);
  image->GetPointData()->SetActiveScalars("Elevation");
  swellray::setGeoreference(image, scene.bathymetry.georeference);
  if (scene.bathymetry.geographic)
  {
    swellray::setGeographicGrid(image, *scene.bathymetry.geographic);
  }
  if (!scene.form.empty())
  {
    swellray::setFieldString(image, "SeafloorForm", scene.form);
  }
  return image;
}

}

vtkSwellSeafloorReader::vtkSwellSeafloorReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkSwellSeafloorReader::~vtkSwellSeafloorReader()
{
  delete[] this->FileName;
  delete[] this->CRS;
  delete[] this->Variable;
}

bool vtkSwellSeafloorReader::Load()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  const std::string name = this->FileName ? this->FileName : "";
  try
  {
    if (name.empty())
    {
      throw std::invalid_argument("no seafloor: give FileName a file or a built-in form");
    }
    swellray::SeafloorOptions options;
    options.waterLevel = this->WaterLevel;
    options.positive = static_cast<swellray::Positive>(this->Positive);
    options.earth = static_cast<swellray::EarthModel>(this->Earth);
    options.crs = this->CRS ? this->CRS : "";
    options.variable = this->Variable ? this->Variable : "";
    options.smooth = this->Smooth;
    if (this->Resample != 0.0)
    {
      options.resample = this->Resample;
    }
    if (this->UseCrop)
    {
      options.crop = { this->Crop[0], this->Crop[1], this->Crop[2], this->Crop[3] };
    }
    if (this->UseNoData)
    {
      options.nodata = this->NoData;
    }
    if (this->MaxGap != -1.0)
    {
      options.maxGap = this->MaxGap;
    }
    options.dropOutliers = this->DropOutliers != 0;
    options.crossValidate = this->CrossValidate != 0;
    const std::string source = describeSource(name, options);
    if (this->Kept && this->Kept->source == source && this->Kept->dates == describeDates(name, this->Kept->report))
    {
      return true;
    }
    this->Kept.reset();
    const swellray::SeafloorScene scene = swellray::loadSeafloor(name, options, swellray::makeExecution(this));
    this->Kept = std::make_unique<Reading>();
    this->Kept->image = imageOf(scene);
    this->Kept->report = scene.bathymetry.report;
    this->Kept->source = source;
    this->Kept->dates = describeDates(name, this->Kept->report);
  }
  catch (const std::exception& error)
  {
    this->Kept.reset();
    std::error_code none;
    const bool missing = dynamic_cast<const std::runtime_error*>(&error) && !std::filesystem::exists(name, none);
    this->SetErrorCode(name.empty()                          ? vtkErrorCode::NoFileNameError
        : missing                                            ? vtkErrorCode::FileNotFoundError
        : dynamic_cast<const std::invalid_argument*>(&error) ? vtkErrorCode::UserError
                                                             : vtkErrorCode::FileFormatError);
    vtkErrorMacro(<< error.what());
    return false;
  }
  return true;
}

int vtkSwellSeafloorReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  // The executive forgets an old abort only later, before RequestData.
  this->AbortExecute = 0;
  if (!this->Load())
  {
    return 0;
  }
  vtkImageData* image = this->Kept->image;
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), image->GetExtent(), 6);
  info->Set(vtkDataObject::ORIGIN(), image->GetOrigin(), 3);
  info->Set(vtkDataObject::SPACING(), image->GetSpacing(), 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_DOUBLE, 1);
  return 1;
}

int vtkSwellSeafloorReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->Load())
  {
    return 0;
  }
  vtkImageData::GetData(outputVector)->ShallowCopy(this->Kept->image);
  return 1;
}

const swellray::SeafloorReport* vtkSwellSeafloorReader::GetReport() const
{
  return this->Kept ? &this->Kept->report : nullptr;
}

int vtkSwellSeafloorReader::GetNumberOfReportLines() const
{
  return this->Kept ? static_cast<int>(this->Kept->report.lines().size()) : 0;
}

std::string vtkSwellSeafloorReader::GetReportLabel(int line) const
{
  return this->Kept ? this->Kept->report.lines().at(static_cast<std::size_t>(line)).first : "";
}

std::string vtkSwellSeafloorReader::GetReportText(int line) const
{
  return this->Kept ? this->Kept->report.lines().at(static_cast<std::size_t>(line)).second : "";
}

void vtkSwellSeafloorReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "WaterLevel: " << this->WaterLevel << "\n";
  const char* directions[] = { "auto", "up", "down" };
  os << indent << "Positive: " << directions[this->Positive] << "\n";
  os << indent << "Earth: " << (this->Earth == ELLIPSOID ? "ellipsoid" : "plane") << "\n";
  os << indent << "CRS: " << (this->CRS ? this->CRS : "(none)") << "\n";
  os << indent << "UseCrop: " << (this->UseCrop ? "on" : "off") << "\n";
  os << indent << "Crop: " << this->Crop[0] << " " << this->Crop[1] << " " << this->Crop[2] << " " << this->Crop[3]
     << "\n";
  os << indent << "Resample: " << this->Resample << "\n";
  os << indent << "Smooth: " << this->Smooth << "\n";
  os << indent << "UseNoData: " << (this->UseNoData ? "on" : "off") << "\n";
  os << indent << "NoData: " << this->NoData << "\n";
  os << indent << "MaxGap: " << this->MaxGap << "\n";
  os << indent << "DropOutliers: " << (this->DropOutliers ? "on" : "off") << "\n";
  os << indent << "CrossValidate: " << (this->CrossValidate ? "on" : "off") << "\n";
  os << indent << "Variable: " << (this->Variable ? this->Variable : "(none)") << "\n";
}
