#include "vtkSwellSea.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "RayArrays.h"
#include "SurfaceSettings.h"
#include "sim/Angles.h"
#include "sim/SeaState.h"
#include "sim/SeaSurface.h"
#include "vtkSwellSeaFunction.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkSwellSea);

namespace
{

constexpr double UsualCells = 256.0;
constexpr double MostCells = 8192.0;

swellray::DirectionalSpreading spreadingOf(int rule, double spread, double peakFrequency)
{
  switch (rule)
  {
  case vtkSwellSea::HASSELMANN:
    return swellray::DirectionalSpreading::hasselmann(peakFrequency);
  case vtkSwellSea::THON:
    return swellray::DirectionalSpreading::hasselmann(peakFrequency, swellray::HasselmannExponent::Thon2000);
  case vtkSwellSea::COSINE_POWER:
    return swellray::DirectionalSpreading::cosinePower(swellray::radians(spread));
  default:
    return swellray::DirectionalSpreading::wrappedNormal(swellray::radians(spread));
  }
}

}

vtkSwellSea::vtkSwellSea()
  : Function(vtkSwellSeaFunction::New())
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

vtkSwellSea::~vtkSwellSea()
{
  this->Function->Delete();
}

int vtkSwellSea::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

int vtkSwellSea::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  try
  {
    for (int port = 0; port < 2; ++port)
    {
      swellray::setTimeSteps(outputVector->GetInformationObject(port), this->TimeRange, this->TimeStep);
    }
    const int last = std::max(this->ImagePixels, 0) - 1;
    const int extent[6] = { 0, last, 0, last, 0, std::min(last, 0) };
    outputVector->GetInformationObject(1)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

std::shared_ptr<const swellray::SeaSurface> vtkSwellSea::makeSurface() const
{
  const double depth = this->Depth != 0.0 ? this->Depth : std::numeric_limits<double>::infinity();
  swellray::SeaState state;
  state.shape = static_cast<swellray::SpectrumShape>(this->Shape);
  state.height = this->SignificantHeight;
  state.peakPeriod = this->PeakPeriod;
  state.peakedness = this->Peakedness;
  state.depth = depth;
  state.gravity = this->Gravity;
  state.wind = this->Wind != 0.0 ? std::optional<double>(this->Wind) : std::nullopt;
  state.fetch = this->Fetch != 0.0 ? std::optional<double>(this->Fetch) : std::nullopt;
  const swellray::FrequencySpectrum spectrum = state.spectrum();
  swellray::SeaSurfaceOptions options;
  if (this->Components < 1)
  {
    throw std::invalid_argument("Components is " + std::to_string(this->Components) + "; it must be 1 to 4096");
  }
  options.components = static_cast<std::size_t>(this->Components);
  options.sharpness = this->Sharpness;
  options.turbulence = this->Turbulence;
  options.tile = this->Tile ? std::optional<double>(this->Size) : std::nullopt;
  options.depth = depth;
  options.gravity = this->Gravity;
  options.seed = static_cast<unsigned>(this->Seed);
  return std::make_shared<swellray::SeaSurface>(spectrum,
    spreadingOf(this->Spreading, this->Spread, spectrum.peakFrequency()),
    swellray::headingFromNautical(this->DirectionFrom), options);
}

void vtkSwellSea::makeMesh(vtkPolyData* mesh, double time)
{
  const double spacing = this->Spacing != 0.0 ? this->Spacing : this->Size / UsualCells;
  if (!(spacing > 0.0 && spacing <= this->Size && this->Size / spacing <= MostCells))
  {
    throw std::invalid_argument("Spacing is " + std::to_string(spacing) +
      "; it must be above 0, at most Size, and at "
      "least Size/8192");
  }
  const auto cells = static_cast<std::size_t>(std::round(this->Size / spacing));
  const double step = this->Size / static_cast<double>(cells);
  const std::size_t side = cells + 1;
  const auto count = static_cast<vtkIdType>(side * side);
  vtkPointData* out = mesh->GetPointData();
  double* heights = swellray::addArray<vtkDoubleArray>(out, "SurfaceHeight", count);
  float* normals = swellray::addArray<vtkFloatArray>(out, "Normals", count, 3);
  float* texture = swellray::addArray<vtkFloatArray>(out, "TextureCoordinates", count, 2);
  swellray::sampleSea(*this->Surface, { this->Corner[0], this->Corner[1] }, step, side, side, time, heights, normals,
    swellray::makeExecution(this, 0.0, this->ImagePixels > 0 ? 0.5 : 1.0));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  for (std::size_t i = 0; i < side * side; ++i)
  {
    const double u = static_cast<double>(i % side) / static_cast<double>(cells);
    const double v = static_cast<double>(i / side) / static_cast<double>(cells);
    points->SetPoint(
      static_cast<vtkIdType>(i), this->Corner[0] + u * this->Size, this->Corner[1] + v * this->Size, heights[i]);
    texture[2 * i] = static_cast<float>(u);
    texture[2 * i + 1] = static_cast<float>(v);
  }
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(static_cast<vtkIdType>(2 * cells * cells), static_cast<vtkIdType>(6 * cells * cells));
  for (std::size_t row = 0; row < cells; ++row)
  {
    for (std::size_t column = 0; column < cells; ++column)
    {
      const auto a = static_cast<vtkIdType>(row * side + column);
      const auto b = a + static_cast<vtkIdType>(side);
      triangles->InsertNextCell({ a, a + 1, b + 1 });
      triangles->InsertNextCell({ a, b + 1, b });
    }
  }
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  out->SetActiveScalars("SurfaceHeight");
  out->SetActiveNormals("Normals");
  out->SetActiveTCoords("TextureCoordinates");
}

void vtkSwellSea::makeImage(vtkImageData* image, double time)
{
  if (this->ImagePixels == 0)
  {
    return;
  }
  if (this->ImagePixels < 2 || this->ImagePixels > static_cast<int>(MostCells))
  {
    throw std::invalid_argument("ImagePixels is " + std::to_string(this->ImagePixels) + "; it must be 0, or 2 to 8192");
  }
  const auto pixels = static_cast<std::size_t>(this->ImagePixels);
  const auto count = static_cast<vtkIdType>(pixels * pixels);
  const double step = this->Size / static_cast<double>(pixels);
  image->SetDimensions(this->ImagePixels, this->ImagePixels, 1);
  image->SetSpacing(step, step, 1.0);
  image->SetOrigin(this->Corner[0] + 0.5 * step, this->Corner[1] + 0.5 * step, 0.0);
  vtkPointData* out = image->GetPointData();
  float* single = swellray::addArray<vtkFloatArray>(out, "SurfaceHeight", count);
  float* normals = swellray::addArray<vtkFloatArray>(out, "Normals", count, 3);
  std::vector<double> heights(pixels * pixels);
  swellray::sampleSea(*this->Surface, { image->GetOrigin()[0], image->GetOrigin()[1] }, step, pixels, pixels, time,
    heights.data(), normals, swellray::makeExecution(this, 0.5, 1.0));
  std::transform(heights.begin(), heights.end(), single, [](double height) { return static_cast<float>(height); });
  out->SetActiveScalars("SurfaceHeight");
}

int vtkSwellSea::RequestData(vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* mesh = vtkPolyData::GetData(outputVector, 0);
  vtkImageData* image = vtkImageData::GetData(outputVector, 1);
  try
  {
    // The time that the output which was asked for is to have.
    const int asked = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
    vtkInformation* info = outputVector->GetInformationObject(asked);
    const double time = swellray::requestedTime(info, this->Time);
    if (!(this->Size > 0.0 && std::isfinite(this->Size)))
    {
      throw std::invalid_argument("Size is " + std::to_string(this->Size) + "; it must be above 0 m");
    }
    // The same waves at all times: they are chosen once.
    if (!this->Surface || this->SurfaceTime != this->GetMTime())
    {
      this->Surface = this->makeSurface();
      this->SurfaceTime = this->GetMTime();
    }
    this->Function->SetSurface(this->Surface);
    this->Function->SetTime(time);
    this->makeMesh(mesh, time);
    this->makeImage(image, time);
    for (vtkDataObject* output : { static_cast<vtkDataObject*>(mesh), static_cast<vtkDataObject*>(image) })
    {
      const swellray::SeaTurbulence* turbulence = this->Surface->turbulence();
      swellray::setFieldValue(output, "Time", time);
      swellray::setFieldInteger(output, "Seed", this->Seed);
      swellray::setFieldValue(output, "Size", this->Size);
      swellray::setFieldValue(output, "SignificantWaveHeight", 4.0 * std::sqrt(this->Surface->meanSquare()));
      swellray::setFieldValue(output, "PeakPeriod", this->Surface->peakPeriod());
      swellray::setFieldValue(output, "HighestFrequency", this->Surface->highestFrequency());
      swellray::setFieldValue(output, "TurbulenceMultiplier", turbulence ? turbulence->multiplier() : 0.0);
      swellray::setFieldValue(output, "TurbulenceAmplitude", turbulence ? turbulence->amplitude() : 0.0);
      swellray::setFieldString(output, "SwellrayVersion", SWELLRAY_VERSION);
      output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    }
    if (this->GetAbortExecute())
    {
      mesh->Initialize();
      image->Initialize();
    }
  }
  catch (const std::exception& error)
  {
    mesh->Initialize();
    image->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkSwellSea::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* shapes[] = { "Pierson-Moskowitz", "JONSWAP", "TMA" };
  const char* spreadings[] = { "Hasselmann", "Thon", "cosine power", "wrapped normal" };
  os << indent << "Shape: " << shapes[this->Shape] << "\n";
  os << indent << "SignificantHeight: " << this->SignificantHeight << "\n";
  os << indent << "PeakPeriod: " << this->PeakPeriod << "\n";
  os << indent << "DirectionFrom: " << this->DirectionFrom << "\n";
  os << indent << "Spreading: " << spreadings[this->Spreading] << "\n";
  os << indent << "Spread: " << this->Spread << "\n";
  os << indent << "Peakedness: " << this->Peakedness << "\n";
  os << indent << "Wind: " << this->Wind << "\n";
  os << indent << "Fetch: " << this->Fetch << "\n";
  os << indent << "Depth: " << this->Depth << "\n";
  os << indent << "Gravity: " << this->Gravity << "\n";
  os << indent << "Components: " << this->Components << "\n";
  os << indent << "Sharpness: " << this->Sharpness << "\n";
  os << indent << "Turbulence: " << (this->Turbulence ? "on" : "off") << "\n";
  os << indent << "Tile: " << (this->Tile ? "on" : "off") << "\n";
  os << indent << "Corner: " << this->Corner[0] << ", " << this->Corner[1] << "\n";
  os << indent << "Size: " << this->Size << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "ImagePixels: " << this->ImagePixels << "\n";
  os << indent << "Time: " << this->Time << "\n";
  os << indent << "TimeRange: " << this->TimeRange[0] << ", " << this->TimeRange[1] << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
