#include "vtkSwellSpectralMap.h"

#include "AlgorithmExecution.h"
#include "CurrentSource.h"
#include "FieldData.h"
#include "GeoreferenceField.h"
#include "PlacesPiece.h"
#include "RayArrays.h"
#include "SeafloorField.h"
#include "TransferSource.h"
#include "bathymetry/SpectrumFile.h"
#include "sim/Angles.h"
#include "sim/ElevationSeries.h"
#include "sim/EllipsoidMercator.h"
#include "sim/SeaState.h"
#include "sim/SpectralSea.h"

#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkSwellSpectralMap);

namespace
{

swellray::SpectralGrid withHeadings(const swellray::SpectralGrid& grid, std::size_t count)
{
  return { grid.frequencies, swellray::SpectralGrid::logarithmic(0.1, 1.0, 2, count).headings };
}

}

vtkSwellSpectralMap::vtkSwellSpectralMap()
  : Seafloor(std::make_unique<swellray::SeafloorField>())
  , Water(std::make_unique<swellray::CurrentField>())
  , Spectra(std::make_unique<std::vector<swellray::DirectionalSpectrum>>())
  , Transfer(std::make_unique<swellray::TransferTable>())
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
}

vtkSwellSpectralMap::~vtkSwellSpectralMap()
{
  delete[] this->BoundaryFileName;
  delete[] this->Current;
  delete[] this->TransferFileName;
}

const swellray::TransferTable& vtkSwellSpectralMap::GetTransferTable() const
{
  return *this->Transfer;
}

const std::vector<swellray::DirectionalSpectrum>& vtkSwellSpectralMap::GetSpectra() const
{
  return *this->Spectra;
}

int vtkSwellSpectralMap::MakeElevations(double duration, double interval, int seed, vtkDoubleArray* elevations)
{
  try
  {
    if (!elevations || this->Spectra->empty())
    {
      throw std::invalid_argument("elevations need an array to go to, and spectra: update with KeepSpectra on");
    }
    swellray::ElevationTimes times;
    times.interval = interval;
    times.seed = static_cast<unsigned>(seed);
    times.cover(duration);
    elevations->SetName("Elevation");
    elevations->SetNumberOfComponents(static_cast<int>(times.count));
    elevations->SetNumberOfTuples(static_cast<vtkIdType>(this->Spectra->size()));
    elevations->Fill(std::numeric_limits<double>::quiet_NaN());
    for (times.index = 0; times.index < this->Spectra->size(); ++times.index)
    {
      const swellray::DirectionalSpectrum& spectrum = (*this->Spectra)[times.index];
      if (!spectrum.density.empty())
      {
        const std::vector<double> record = swellray::elevationSeries(spectrum, times);
        std::copy(
          record.begin(), record.end(), elevations->GetPointer(static_cast<vtkIdType>(times.index * times.count)));
      }
    }
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

int vtkSwellSpectralMap::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataSet" : "vtkImageData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkSwellSpectralMap::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* out = outputVector->GetInformationObject(0);
  if (out->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    out->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  }
  return 1;
}

int vtkSwellSpectralMap::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  // Rays come from far away: all of the seafloor is needed. And all places, as not every source can give a part of them.
  for (int port = 0; port < 2; ++port)
  {
    if (vtkInformation* input = inputVector[port]->GetInformationObject(0))
    {
      input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
      input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
      if (input->Has(Pipeline::WHOLE_EXTENT()))
      {
        input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
      }
    }
  }
  return 1;
}

int vtkSwellSpectralMap::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkSmartPointer<vtkDataSet> places = vtkDataSet::GetData(inputVector[0]);
  vtkImageData* image = vtkImageData::GetData(inputVector[1]);
  vtkDataSet* output = vtkDataSet::GetData(outputVector);
  try
  {
    if (!image)
    {
      image = vtkImageData::SafeDownCast(places);
    }
    vtkInformation* asked = outputVector->GetInformationObject(0);
    const int pieces = asked->Get(Pipeline::UPDATE_NUMBER_OF_PIECES());
    if (pieces > 1)
    {
      places = swellray::pieceOf(
        places, asked->Get(Pipeline::UPDATE_EXTENT()), asked->Get(Pipeline::UPDATE_PIECE_NUMBER()), pieces);
    }
    if (!image)
    {
      throw std::invalid_argument("the seafloor is missing: connect it to input 1");
    }
    if (this->NumberOfFrequencies < 2 || this->NumberOfDirections < 4 || this->RaysPerDirection < 1)
    {
      throw std::invalid_argument("a spectrum needs 2 or more frequencies (not " +
        std::to_string(this->NumberOfFrequencies) + "), 4 or more directions (not " +
        std::to_string(this->NumberOfDirections) + ") and 1 or more rays a direction (not " +
        std::to_string(this->RaysPerDirection) + ")");
    }
    const double offshoreDepth =
      this->OffshoreDepth != 0.0 ? this->OffshoreDepth : std::numeric_limits<double>::infinity();
    swellray::SeaState state;
    state.shape = static_cast<swellray::SpectrumShape>(this->Shape);
    state.height = this->SignificantHeight;
    state.peakPeriod = this->PeakPeriod;
    state.directionFrom = this->DirectionFrom;
    state.spread = this->Spread;
    state.peakedness = this->Peakedness;
    state.depth = offshoreDepth;
    state.gravity = this->Gravity;
    state.wind = this->Wind != 0.0 ? std::optional<double>(this->Wind) : std::nullopt;
    state.fetch = this->Fetch != 0.0 ? std::optional<double>(this->Fetch) : std::nullopt;
    const bool ofFile = this->BoundaryFileName && *this->BoundaryFileName;
    const std::string transferFile = this->TransferFileName ? this->TransferFileName : "";
    if (pieces > 1 && !transferFile.empty())
    {
      throw std::invalid_argument("the transfer file '" + transferFile + "' is for one piece, not one of " +
        std::to_string(pieces) + ": several would write it at once");
    }
    const bool table = this->KeepTransfer || !transferFile.empty();
    const auto frequencies = static_cast<std::size_t>(this->NumberOfFrequencies);
    const auto directions = static_cast<std::size_t>(this->NumberOfDirections);
    const swellray::DirectionalSpectrum read =
      ofFile ? swellray::readSpectra(this->BoundaryFileName).records.front().spectrum : swellray::DirectionalSpectrum();
    swellray::SpectralSeaOptions options;
    swellray::TransferTable& kept = *this->Transfer;
    kept = transferFile.empty() ? swellray::TransferTable() : swellray::readTransferTableIfThere(transferFile);
    if (!kept.rays.grid.frequencies.empty())
    {
      options.rays = kept.rays;
    }
    else
    {
      const bool ranged = this->FrequencyRange[0] != 0.0 || this->FrequencyRange[1] != 0.0;
      options.rays.grid = ranged
        ? swellray::SpectralGrid::logarithmic(this->FrequencyRange[0], this->FrequencyRange[1], frequencies, directions)
        : ofFile ? swellray::spectralGridOf(read, frequencies, directions)
                 : swellray::spectralGridOf(state.spectrum(), frequencies, directions);
      options.rays.perDirection = static_cast<std::size_t>(this->RaysPerDirection);
    }
    options.breaking =
      static_cast<swellray::BreakingRule>(std::clamp(this->BreakingRule, 0, swellray::BreakingRuleCount - 1));
    options.gamma = this->Gamma != 0.0 ? std::optional<double>(this->Gamma) : std::nullopt;
    const swellray::SpectralGrid offshoreGrid = withHeadings(options.rays.grid, swellray::OffshoreDirections);
    const swellray::DirectionalSpectrum sea = ofFile
      ? swellray::resample(read, offshoreGrid)
      : swellray::DirectionalSpectrum::sample(offshoreGrid, state.spectrum(),
          swellray::DirectionalSpreading::cosinePower(swellray::radians(state.spread)),
          swellray::headingFromNautical(state.directionFrom));

    vtkDataArray* elevation = vtkImageData::GetData(inputVector[1]) ? this->GetInputArrayToProcess(0, inputVector)
                                                                    : image->GetPointData()->GetArray("Elevation");
    const std::shared_ptr<const swellray::Seafloor> seafloor = this->Seafloor->get(image, elevation);
    swellray::BackwardOptions backward;
    backward.waterLevel = this->WaterLevel;
    backward.gravity = this->Gravity;
    backward.tolerance = this->Tolerance;
    backward.offshoreDepth = offshoreDepth;
    backward.edge = static_cast<swellray::EdgeRule>(this->Edge);
    backward.shoreNormal = this->UseShoreNormal ? std::optional<double>(this->ShoreNormal) : std::nullopt;
    backward.friction = this->Friction;
    const swellray::Georeference scene = swellray::georeferenceOf(image);
    backward.map = scene.mercator().get();
    std::shared_ptr<const swellray::Current> current;
    if (this->Current && *this->Current)
    {
      current = this->Water->get(this->Current, scene, seafloor->bounds());
      backward.current = current.get();
    }
    const swellray::BackwardTracer tracer(*seafloor, backward);

    const vtkIdType count = places->GetNumberOfPoints();
    std::vector<glm::dvec2> points(static_cast<std::size_t>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      double p[3];
      places->GetPoint(i, p);
      points[static_cast<std::size_t>(i)] = { p[0], p[1] };
    }
    std::vector<swellray::DirectionalSpectrum>* spectra = this->KeepSpectra ? this->Spectra.get() : nullptr;
    std::vector<swellray::PlaceSea> seas;
    if (table)
    {
      const std::vector<std::string> description =
        swellray::describeScene(image, elevation, backward, frequencies, directions, options.rays.perDirection);
      constexpr double TracingShare = 0.95;
      swellray::completeTransferTable(transferFile, kept, description, options.rays, tracer, points,
        swellray::makeExecution(this, 0.0, TracingShare), "Swellray " SWELLRAY_VERSION);
      if (!this->GetAbortExecute())
      {
        seas =
          swellray::transformSea(options, sea, kept.places, swellray::makeExecution(this, TracingShare, 1.0), spectra);
      }
    }
    else
    {
      seas = swellray::transformSea(tracer, options, sea, points, swellray::makeExecution(this), spectra);
    }
    if (this->GetAbortExecute())
    {
      output->Initialize();
      return 1;
    }

    output->ShallowCopy(places);
    vtkPointData* out = output->GetPointData();
    const auto add = [=](const char* name) { return swellray::addArray<vtkDoubleArray>(out, name, count); };
    double* depth = add("Depth");
    double* height = add("SignificantWaveHeight");
    double* peak = add("PeakPeriod");
    double* mean = add("MeanPeriod");
    double* crossing = add("ZeroCrossingPeriod");
    double* energy = add("EnergyPeriod");
    double* direction = add("MeanDirectionFrom");
    double* spread = add("DirectionalSpread");
    unsigned char* breaking = swellray::addArray<vtkUnsignedCharArray>(out, "Breaking", count);
    double rays = 0.0;
    double steps = 0.0;
    for (std::size_t i = 0; i < seas.size(); ++i)
    {
      const swellray::SeaParameters& here = seas[i].parameters;
      depth[i] = seas[i].depth;
      height[i] = here.significantHeight;
      peak[i] = here.peakPeriod;
      mean[i] = here.meanPeriod01;
      crossing[i] = here.meanPeriod02;
      energy[i] = here.energyPeriod;
      direction[i] = here.meanDirectionFrom;
      spread[i] = here.spread;
      breaking[i] = seas[i].breaking ? 1 : 0;
      rays += static_cast<double>(seas[i].rays);
      steps += static_cast<double>(seas[i].steps);
    }
    out->SetActiveScalars("SignificantWaveHeight");
    output->GetFieldData()->PassData(image->GetFieldData());
    swellray::dropGeographicGrid(output);
    const swellray::SeaParameters offshore = swellray::seaParameters(sea);
    swellray::setFieldValue(output, "OffshoreSignificantWaveHeight", offshore.significantHeight);
    swellray::setFieldValue(output, "OffshorePeakPeriod", offshore.peakPeriod);
    swellray::setFieldValue(output, "OffshoreMeanDirectionFrom", offshore.meanDirectionFrom);
    swellray::setFieldValue(output, "OffshoreDirectionalSpread", offshore.spread);
    swellray::setFieldValue(output, "WaterLevel", this->WaterLevel);
    swellray::setFieldValue(output, "Rays", rays);
    swellray::setFieldValue(output, "RaySteps", steps);
    swellray::setFieldString(output, "SwellrayVersion", SWELLRAY_VERSION);
    for (const std::string& note : current ? this->Water->notes() : std::vector<std::string>())
    {
      vtkWarningMacro(<< note);
    }
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkSwellSpectralMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* shapes[] = { "Pierson-Moskowitz", "JONSWAP", "TMA" };
  const char* edges[] = { "contours", "edge", "none" };
  os << indent << "Shape: " << shapes[this->Shape] << "\n";
  os << indent << "SignificantHeight: " << this->SignificantHeight << "\n";
  os << indent << "PeakPeriod: " << this->PeakPeriod << "\n";
  os << indent << "DirectionFrom: " << this->DirectionFrom << "\n";
  os << indent << "Spread: " << this->Spread << "\n";
  os << indent << "Peakedness: " << this->Peakedness << "\n";
  os << indent << "Wind: " << this->Wind << "\n";
  os << indent << "Fetch: " << this->Fetch << "\n";
  os << indent << "BoundaryFileName: " << (this->BoundaryFileName ? this->BoundaryFileName : "(none)") << "\n";
  os << indent << "NumberOfFrequencies: " << this->NumberOfFrequencies << "\n";
  os << indent << "NumberOfDirections: " << this->NumberOfDirections << "\n";
  os << indent << "RaysPerDirection: " << this->RaysPerDirection << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "BreakingRule: " << this->BreakingRule << "\n";
  os << indent << "Gamma: " << this->Gamma << "\n";
  os << indent << "Friction: " << this->Friction << "\n";
  os << indent << "OffshoreDepth: " << this->OffshoreDepth << "\n";
  os << indent << "Gravity: " << this->Gravity << "\n";
  os << indent << "WaterLevel: " << this->WaterLevel << "\n";
  os << indent << "Edge: " << edges[this->Edge] << "\n";
  os << indent << "UseShoreNormal: " << (this->UseShoreNormal ? "on" : "off") << "\n";
  os << indent << "ShoreNormal: " << this->ShoreNormal << "\n";
  os << indent << "Current: " << (this->Current ? this->Current : "(none)") << "\n";
  os << indent << "FrequencyRange: " << this->FrequencyRange[0] << ", " << this->FrequencyRange[1] << "\n";
  os << indent << "TransferFileName: " << (this->TransferFileName ? this->TransferFileName : "(none)") << "\n";
  os << indent << "KeepTransfer: " << (this->KeepTransfer ? "on" : "off") << "\n";
  os << indent << "KeepSpectra: " << (this->KeepSpectra ? "on" : "off") << "\n";
}
