#include "Commands.h"
#include "ElevationOutput.h"
#include "Failure.h"
#include "FieldValues.h"
#include "FilterRun.h"
#include "MapOutput.h"
#include "OptionGroups.h"
#include "OptionKinds.h"
#include "Pipeline.h"
#include "SeaOptions.h"
#include "SeaSeries.h"
#include "StationTable.h"
#include "Sweep.h"
#include "WorkPlan.h"

#include "bathymetry/SpectrumFile.h"
#include "bathymetry/TransferFile.h"

#include <fmt/format.h>

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSwellSpectralMap.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

namespace swellray::cli
{

namespace
{

// Nodes of a map without --map-spacing: a minute or so of rays.
constexpr double UsualNodes = 2500.0;

const NumberRule StepErrors{ "", 1e-14, 1e-2 };

void setUp(vtkSwellSpectralMap* filter, const Request& request)
{
  const SpectrumRequest& sea = request.spectrum;
  filter->SetShape(static_cast<int>(sea.shape));
  filter->SetSignificantHeight(sea.height.value_or(filter->GetSignificantHeight()));
  filter->SetPeakPeriod(sea.peakPeriod.value_or(filter->GetPeakPeriod()));
  filter->SetDirectionFrom(sea.directionFrom.value_or(filter->GetDirectionFrom()));
  filter->SetSpread(sea.spread);
  filter->SetPeakedness(sea.peakedness);
  filter->SetWind(sea.wind.value_or(0.0));
  filter->SetFetch(sea.fetch.value_or(0.0));
  filter->SetBoundaryFileName(sea.boundary.empty() ? nullptr : sea.boundary.c_str());
  filter->SetNumberOfFrequencies(sea.frequencies);
  filter->SetNumberOfDirections(sea.directions);
  filter->SetRaysPerDirection(sea.raysPerDirection);
  filter->SetTolerance(sea.tolerance);
  filter->SetBreakingRule(static_cast<int>(sea.breaking));
  filter->SetGamma(sea.gamma.value_or(0.0));
  filter->SetFriction(sea.friction);
  filter->SetOffshoreDepth(request.rays.wave.offshoreDepth);
  filter->SetGravity(request.rays.wave.gravity);
  filter->SetWaterLevel(request.seafloor.options.waterLevel);
  filter->SetEdge(request.rays.trace.edge == EdgeRule::Contours ? vtkSwellSpectralMap::EDGE_CONTOURS
      : request.rays.trace.edge == EdgeRule::Edge               ? vtkSwellSpectralMap::EDGE_EDGE
                                                                : vtkSwellSpectralMap::EDGE_NONE);
  if (request.rays.trace.shoreNormal)
  {
    filter->UseShoreNormalOn();
    filter->SetShoreNormal(*request.rays.trace.shoreNormal);
  }
  filter->SetCurrent(request.rays.current.empty() ? nullptr : request.rays.current.c_str());
  filter->SetTransferFileName(sea.transfer.empty() ? nullptr : sea.transfer.c_str());
  if (sea.frequencyRange)
  {
    filter->SetFrequencyRange((*sea.frequencyRange)[0], (*sea.frequencyRange)[1]);
  }
}

// What a series does not say itself.
SeaState formOf(const Request& request)
{
  SeaState form;
  form.shape = request.spectrum.shape;
  form.peakedness = request.spectrum.peakedness;
  form.spread = request.spectrum.spread;
  form.depth = request.rays.wave.offshoreDepth;
  form.gravity = request.rays.wave.gravity;
  return form;
}

// The rays of a series hold all of its seas; the filter itself needs one of them.
void setUp(vtkSwellSpectralMap* filter, const SeaSeries& series, const Request& request)
{
  if (!request.spectrum.frequencyRange)
  {
    const std::array<double, 2> band = series.band();
    filter->SetFrequencyRange(band[0], band[1]);
  }
  if (const std::optional<SeaState> first = series.firstState())
  {
    filter->SetSignificantHeight(first->height);
    filter->SetPeakPeriod(first->peakPeriod);
    filter->SetDirectionFrom(first->directionFrom);
    filter->SetSpread(first->spread);
  }
  else
  {
    filter->SetBoundaryFileName(request.spectrum.series.c_str());
  }
  filter->KeepTransferOn();
}

// Nodes over the seafloor, at the spacing asked for or so that there are not too many.
vtkNew<vtkImageData> mapNodes(vtkImageData* seafloor, const Request& request, Console& console)
{
  double bounds[6];
  seafloor->GetBounds(bounds);
  const double width = bounds[1] - bounds[0];
  const double height = bounds[3] - bounds[2];
  const double spacing =
    request.map.spacing.value_or(std::max(std::sqrt(width * height / UsualNodes), seafloor->GetSpacing()[0]));
  constexpr double rounding = 1e-9;
  constexpr double MostNodes = 1e7;
  const double columns = std::floor(width / spacing + rounding) + 1.0;
  const double rows = std::floor(height / spacing + rounding) + 1.0;
  if (columns * rows > MostNodes)
  {
    throw WorkError(fmt::format(
      "a map of {:.4g} nodes {:g} m apart is too large; choose a larger --map-spacing", columns * rows, spacing));
  }
  vtkNew<vtkImageData> nodes;
  nodes->SetDimensions(static_cast<int>(columns), static_cast<int>(rows), 1);
  nodes->SetOrigin(bounds[0], bounds[2], 0.0);
  nodes->SetSpacing(spacing, spacing, 1.0);
  console.say(fmt::format("map      {:g} x {:g} nodes {:.4g} m apart", columns, rows, spacing));
  return nodes;
}

void saySea(vtkDataObject* data, const SpectrumRequest& sea, Console& console)
{
  const auto number = [&](const char* name) { return fieldNumber(data, name).value_or(std::nan("")); };
  console.say(fmt::format("offshore Hs {:.3g} m, Tp {:.3g} s, from {:.4g} degrees, spread {:.3g} degrees",
    number("OffshoreSignificantWaveHeight"), number("OffshorePeakPeriod"), number("OffshoreMeanDirectionFrom"),
    number("OffshoreDirectionalSpread")));
  console.say(fmt::format(
    "rays     {} frequencies, {} directions, {} a direction", sea.frequencies, sea.directions, sea.raysPerDirection));
}

void sayHeights(vtkDataSet* data, const char* what, double seconds, Console& console)
{
  vtkDataArray* heights = data->GetPointData()->GetArray("SignificantWaveHeight");
  vtkDataArray* breaking = data->GetPointData()->GetArray("Breaking");
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  vtkIdType wet = 0;
  vtkIdType broken = 0;
  for (vtkIdType i = 0; i < heights->GetNumberOfTuples(); ++i)
  {
    const double height = heights->GetComponent(i, 0);
    if (std::isfinite(height))
    {
      least = std::min(least, height);
      most = std::max(most, height);
      ++wet;
      broken += breaking->GetComponent(i, 0) > 0.0 ? 1 : 0;
    }
  }
  if (wet == 0)
  {
    console.warn(fmt::format("none of the {} lies in water", what));
    return;
  }
  console.say(
    fmt::format("{:<8} Hs {:.3g} to {:.3g} m; limited by the depth at {} of {}", what, least, most, broken, wet));
  const auto count = [&](const char* name) { return fieldNumber(data, name).value_or(0.0); };
  console.say(fmt::format("traced   {:.0f} rays in {:.0f} steps; {:.3g} s, {:.3g} rays a second", count("Rays"),
    count("RaySteps"), seconds, count("Rays") / seconds));
}

std::vector<SpectrumRecord> recordsOf(vtkSwellSpectralMap* filter, vtkPolyData* places, const Georeference& scene)
{
  std::vector<SpectrumRecord> records;
  const auto& spectra = filter->GetSpectra();
  for (std::size_t i = 0; i < spectra.size(); ++i)
  {
    if (spectra[i].density.empty())
    {
      continue;
    }
    double point[3];
    places->GetPoint(static_cast<vtkIdType>(i), point);
    SpectrumRecord record;
    record.geographic = scene.kind() == GeoreferenceKind::Geographic;
    record.place = scene.toFile({ point[0], point[1] });
    record.spectrum = spectra[i];
    records.push_back(std::move(record));
  }
  return records;
}

// Some of the places, evenly chosen.
vtkNew<vtkPolyData> sampleOf(vtkDataSet* places, vtkIdType most)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkIdType count = places->GetNumberOfPoints();
  const vtkIdType taken = std::min(count, most);
  for (vtkIdType i = 0; i < taken; ++i)
  {
    points->InsertNextPoint(places->GetPoint((2 * i + 1) * count / (2 * taken)));
  }
  vtkNew<vtkPolyData> sample;
  sample->SetPoints(points);
  return sample;
}

// What the rays of these places will take, by those of a few of them.
void planRays(
  vtkSwellSpectralMap* filter, vtkDataSet* places, const char* what, std::size_t raysAPlace, Console& console)
{
  constexpr vtkIdType Sampled = 12;
  filter->SetTransferFileName(nullptr);
  // The first place waits for the seafloor's spline, which is made once.
  filter->SetInputData(0, sampleOf(places, 1));
  runFilter(filter, "planning", console);
  const vtkNew<vtkPolyData> sample = sampleOf(places, Sampled);
  filter->SetInputData(0, sample);
  const auto begin = std::chrono::steady_clock::now();
  runFilter(filter, "planning", console);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  vtkDataArray* heights = filter->GetOutput()->GetPointData()->GetArray("SignificantWaveHeight");
  double wet = 0.0;
  for (vtkIdType i = 0; i < heights->GetNumberOfTuples(); ++i)
  {
    wet += std::isfinite(heights->GetComponent(i, 0)) ? 1.0 : 0.0;
  }
  const double share =
    static_cast<double>(places->GetNumberOfPoints()) / static_cast<double>(sample->GetNumberOfPoints());
  const auto whole = [&](double sampled) { return Estimate{ share * sampled, share * sampled }; };
  const auto traced = [&](const char* name) { return whole(fieldNumber(filter->GetOutput(), name).value_or(0.0)); };
  const Estimate rays = traced("Rays");
  console.say(fmt::format("plan     {} rays in {} steps from {} {}, some {:.0f} of them in water; {} rays a place",
    rays.text(), traced("RaySteps").text(), places->GetNumberOfPoints(), what, share * wet, raysAPlace));
  constexpr double NumbersARay = 2.0;
  console.say(fmt::format("cost     {}; {} of memory where the rays are kept (--transfer, --series)",
    timeText(whole(seconds.count())), memoryText(NumbersARay * sizeof(double) * rays)));
}

void runSpectrum(const Request& request, Console& console)
{
  std::vector<std::string> inputs = inputFiles(request);
  std::vector<std::unique_ptr<OutputFile>> files;
  const auto open = [&](const std::string& path)
  {
    if (!path.empty() && !request.planOnly)
    {
      files.push_back(std::make_unique<OutputFile>(path, inputs));
    }
    return path.empty() || request.planOnly ? nullptr : files.back().get();
  };
  const OutputFile* const mapFile = open(request.output.map);
  const OutputFile* const tableFile = open(request.output.table);
  const OutputFile* const spectraFile = open(request.output.spectra);
  const OutputFile* const elevationFile = open(request.output.elevations);
  const UnfinishedFile transferPart(
    request.spectrum.transfer.empty() ? std::string() : transferTablePart(request.spectrum.transfer));
  std::optional<StationTable> stations;
  if (!request.map.stations.empty())
  {
    stations.emplace(request.map.stations);
  }
  Pipeline pipeline(request, console);
  vtkImageData* seafloor = pipeline.readSeafloor()->GetOutput();
  const Georeference scene = georeferenceOf(seafloor);
  const SpectrumRequest& sea = request.spectrum;
  const auto raysAPlace = static_cast<std::size_t>(sea.frequencies * sea.directions * sea.raysPerDirection);

  vtkNew<vtkSwellSpectralMap> filter;
  setUp(filter, request);
  std::optional<SeaSeries> series;
  if (!sea.series.empty())
  {
    series.emplace(sea.series, formOf(request));
    setUp(filter, *series, request);
  }
  filter->SetInputData(1, seafloor);
  if (request.planOnly)
  {
    if (stations)
    {
      planRays(filter, stations->places(scene), "stations", raysAPlace, console);
    }
    if (!request.output.map.empty())
    {
      const vtkNew<vtkImageData> nodes = mapNodes(seafloor, request, console);
      planRays(filter, nodes, "nodes", raysAPlace, console);
    }
    return;
  }
  bool said = false;
  const auto run = [&](vtkDataSet* places, const char* task)
  {
    const auto begin = std::chrono::steady_clock::now();
    filter->SetInputData(0, places);
    runFilter(filter, task, console);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    if (series)
    {
      console.say(fmt::format("traced   {:.3g} s", seconds.count()));
      return;
    }
    if (!said)
    {
      saySea(filter->GetOutputDataObject(0), sea, console);
      said = true;
    }
    sayHeights(filter->GetOutput(), task, seconds.count(), console);
  };
  if (stations)
  {
    const auto places = stations->places(scene);
    filter->SetKeepSpectra(spectraFile || elevationFile);
    run(places, "stations");
    if (series)
    {
      const TransferTable& table = filter->GetTransferTable();
      const std::optional<double> gamma =
        sea.breaking == BreakingRule::Gamma ? std::optional<double>(sea.gamma.value_or(SaturationGamma)) : std::nullopt;
      const SeriesOutcome outcome =
        writeSeaSeries(*series, table.rays, table.places, gamma, *stations, *tableFile, console);
      console.say(
        fmt::format("series   {} times at {} stations in {:.3g} s", series->size(), stations->size(), outcome.seconds));
    }
    else if (tableFile)
    {
      stations->write(filter->GetOutput()->GetPointData(),
        { "Depth", "SignificantWaveHeight", "PeakPeriod", "MeanPeriod", "ZeroCrossingPeriod", "EnergyPeriod",
          "MeanDirectionFrom", "DirectionalSpread", "Breaking" },
        "SignificantWaveHeight", *tableFile, console);
    }
    if (elevationFile)
    {
      writeElevations(filter->GetSpectra(), request, *elevationFile, console);
    }
    if (spectraFile)
    {
      try
      {
        const bool netcdf = std::filesystem::path(spectraFile->path()).extension() == ".nc";
        (netcdf ? writeNetcdfSpectra : writeSwanSpectra)(spectraFile->temporary(), recordsOf(filter, places, scene),
          "Swellray " SWELLRAY_VERSION ": " + request.commandLine);
      }
      catch (const std::exception& error)
      {
        spectraFile->fail(error.what());
      }
    }
    filter->KeepSpectraOff();
  }
  if (mapFile)
  {
    const vtkNew<vtkImageData> nodes = mapNodes(seafloor, request, console);
    run(nodes, "map");
    writeMap(vtkImageData::SafeDownCast(filter->GetOutput()), *mapFile, request, console);
  }
  std::string written;
  for (const auto& file : files)
  {
    file->commit();
    written += (written.empty() ? "" : " and ") + file->path();
  }
  console.say("wrote    " + written);
}

void checkSpectrum(Request& request)
{
  const SpectrumRequest& sea = request.spectrum;
  const OutputRequest& output = request.output;
  checkOutputs(output);
  if (request.planOnly && !request.variation.empty())
  {
    throw UsageError("--dry-run plans one sea; leave out lists of values");
  }
  const bool atStations = !(output.table.empty() && output.spectra.empty() && output.elevations.empty());
  if (output.map.empty() && !atStations)
  {
    throw UsageError("spectrum has nothing to write: give --map FILE, or --stations POINTS.csv with --table OUT.csv, "
                     "--spectra OUT.sp2 or --elevation-series OUT.csv");
  }
  if (request.map.stations.empty() == atStations)
  {
    throw UsageError("--stations belongs together with --table, --spectra or --elevation-series; give both");
  }
  checkElevation(request);
  if (request.map.spacing && output.map.empty())
  {
    throw UsageError("--map-spacing needs --map FILE");
  }
  const bool byHeight = sea.height || sea.peakPeriod;
  if (byHeight + sea.wind.has_value() + !sea.boundary.empty() + !sea.series.empty() != 1)
  {
    throw UsageError("the sea offshore is given in one of four ways: --hs and --tp, or --wind, or --boundary FILE, or "
                     "--series FILE");
  }
  if (!sea.series.empty() &&
    (output.table.empty() || !output.map.empty() || !output.spectra.empty() || !output.elevations.empty()))
  {
    throw UsageError("--series makes a table in time: give --stations and --table, and no other output");
  }
  if (!sea.transfer.empty() && (sea.transfer == output.map || sea.transfer == output.spectra))
  {
    throw UsageError("--transfer and another output name the same file; give two");
  }
  checkSeaState(sea);
  if (sea.boundary.empty() && sea.series.empty() && !sea.directionFrom)
  {
    throw UsageError("spectrum needs --direction DEG");
  }
  if (ofRandomWaves(sea.breaking) && !(sea.series.empty() && sea.transfer.empty()))
  {
    throw UsageError(fmt::format("--breaking {} traces rays for each sea alone: leave out --series and --transfer, or "
                                 "choose --breaking gamma",
      breakingRuleName(sea.breaking)));
  }
  if (sea.shape == SpectrumShape::Tma && !std::isfinite(request.rays.wave.offshoreDepth))
  {
    throw UsageError("--shape tma needs --offshore-depth M, the depth in which it holds");
  }
}

OptionSpec frequencyRangeOption(SpectrumRequest& sea)
{
  OptionSpec spec{ "--frequency-range", "F0,F1", "lowest and highest frequency of the rays, Hz",
    "the band that holds 99.5 % of the energy", "Rays", false, {} };
  spec.set = [&sea](const std::string& typed)
  {
    const auto values = parseNumbers("--frequency-range", typed, { "Hz", 0.0, 1e3, true });
    if (values.size() != 2 || !(values[0] < values[1]))
    {
      throw UsageError(fmt::format("--frequency-range needs F0,F1 with F0 < F1, not '{}'", typed));
    }
    sea.frequencyRange = { values[0], values[1] };
  };
  return spec;
}

OptionSpec whole(const char* name, const char* help, const char* standard, int& target, int least, int most)
{
  OptionSpec spec{ name, "N", help, standard, "Rays", false, {} };
  const std::string longName = spec.longName();
  spec.set = [&target, longName, least, most](const std::string& typed)
  { target = static_cast<int>(parseWhole(longName, typed, least, most)); };
  return spec;
}

std::vector<OptionSpec> seaOptions(SpectrumRequest& sea)
{
  const char* group = "Sea offshore";
  std::vector<OptionSpec> options = seaStateOptions(sea, group);
  add(options,
    { spreadOption(sea.spread, group),
      text("--boundary", "FILE",
        "the sea of a spectral file: SWAN (.bnd, .sp1, .sp2), NetCDF (WAVEWATCH III), or a buoy of NDBC", "", group,
        sea.boundary),
      text("--series", "FILE",
        "seas in time: .csv with time, hs, tp, direction, and spread if it varies, or a spectral file", "", group,
        sea.series) });
  return options;
}

}

CommandSpec spectrumSpec(Request& request)
{
  CommandSpec spec{ "spectrum", "refract a directional spectrum: wave heights, periods and directions of a sea", true,
    {}, {} };
  SpectrumRequest& sea = request.spectrum;
  spec.options = { outputFile(
                     "--map", "the sea on a grid, .vti, .nc or .tif", request.output.map, { ".vti", ".nc", ".tif" }),
    text("--stations", "FILE", "points x,y or lon,lat a line, .csv", "", "Output", request.map.stations),
    outputFile("--table", "the sea at the stations, .csv", request.output.table, { ".csv" }),
    outputFile("--spectra", "directional spectra at the stations, SWAN .sp2 or NetCDF .nc", request.output.spectra,
      { ".sp2", ".nc" }),
    number("--map-spacing", "M", "distance of the nodes of the map, m", "2,500 nodes", "Output", request.map.spacing,
      PositiveMetres),
    flag("--dry-run", "only say what the work will take", "Output", request.planOnly),
    flag("--compress", "compress the files (smaller, slower)", "Output", request.output.compress) };
  add(spec.options, elevationOptions(request));
  add(spec.options, seaOptions(sea));
  OptionSpec transfer = outputFile(
    "--transfer", "keep the rays in this file, and take from it those that it has, .nc", sea.transfer, { ".nc" });
  transfer.group = "Rays";
  add(spec.options,
    { transfer, frequencyRangeOption(sea),
      whole(
        "--frequencies", "frequencies over the band that holds 99.5 % of the energy", "20", sea.frequencies, 2, 1000),
      whole("--directions", "directions around the circle", "36", sea.directions, 4, 3600),
      whole("--rays-per-direction", "rays back from each place in each direction", "1", sea.raysPerDirection, 1, 100),
      number(
        "--tolerance", "E", "relative error a step of the integrator", "1e-5", "Rays", sea.tolerance, StepErrors) });
  add(spec.options, offshoreOptions(request.rays));
  const char* group = "Heights";
  add(spec.options,
    { choice("--breaking", "what limits the height in shallow water", "gamma", group, sea.breaking,
        std::vector<std::pair<std::string, BreakingRule>>{ { "gamma", BreakingRule::Gamma },
          { "battjes-janssen", BreakingRule::BattjesJanssen }, { "baldock", BreakingRule::Baldock },
          { "none", BreakingRule::None } }),
      number("--gamma", "G", "largest Hs over depth; battjes-janssen, baldock: breaker index",
        "0.6; battjes-janssen: by the steepness; baldock: by the kh of each place", group, sea.gamma, PositiveNumber),
      number("--friction", "C", "bottom friction coefficient, m2/s3 (0.038: swell over sand; 0.067: storm sea)", "0",
        group, sea.friction, NonNegativeNumber) });
  add(spec.options, seafloorOptions(request.seafloor.options));
  allowLists(spec.options, { "--hs", "--tp", "--direction", "--spread", "--wind", "--water-level" });
  spec.examples =
    "  swellray spectrum harbour.tif --hs 2.5 --tp 11 --direction 240 --spread 20 --map sea.nc\n"
    "  swellray spectrum harbour.tif --wind 15 --fetch 80000 --direction 270 --stations buoys.csv --table sea.csv\n"
    "  swellray spectrum estuary.swn --boundary west.bnd --stations buoys.csv --table sea.csv --spectra sea.sp2\n"
    "  swellray spectrum harbour.tif --series hindcast.csv --transfer rays.nc --stations buoys.csv --table sea.csv\n"
    "  swellray spectrum harbour.tif --hs 2.5 --tp 11 --direction 240 --stations buoys.csv --elevation-series eta.csv "
    "--duration 3600\n"
    "  swellray spectrum harbour.tif --hs 2 --tp 8:16:2 --direction 200:260:10 --stations buoys.csv --table sea.csv\n"
    "  swellray spectrum plane --hs 1 --tp 8 --direction 60 --map sea.vti --rays-per-direction 3\n";
  spec.check = checkSpectrum;
  spec.run = runSpectrum;
  return spec;
}

}
