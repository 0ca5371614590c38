#include "OptionGroups.h"

#include "Failure.h"
#include "OptionKinds.h"

#include "sim/BuiltinCurrent.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace swellray::cli
{

namespace
{

// A tolerance beyond these either cannot be met in double precision or says nothing.
const NumberRule Tolerance{ "", 1e-14, 1e-2 };

OptionSpec offshoreDepthOption(IncidentWave& wave, const char* name = "--offshore-depth",
  const char* help = "depth in which height and direction are given, m")
{
  OptionSpec depth{ name, "M|deep", help, "deep", "Incident wave", false, {} };
  depth.set = [&wave, name](const std::string& typed)
  {
    wave.offshoreDepth =
      typed == "deep" ? std::numeric_limits<double>::infinity() : parseNumber(name, typed, PositiveMetres);
  };
  return depth;
}

OptionSpec sourceOption(
  RayRequest& rays, const char* name, const char* value, const char* help, RayRequest::Source source)
{
  OptionSpec spec{ name, value, help, "", "Incident wave", false, {} };
  spec.set = [&rays, name, value, source](const std::string& typed)
  {
    const auto values = parseNumbers(name, typed, PlainNumber);
    if (values.size() != 2)
    {
      throw UsageError(fmt::format("{} needs {}, not '{}'", name, value, typed));
    }
    if (source == RayRequest::Source::Storm && (std::abs(values[0]) > 360.0 || std::abs(values[1]) > 90.0))
    {
      throw UsageError(fmt::format(
        "{} needs a longitude within -360 to 360 and a latitude within -90 to 90 degrees, not '{}'", name, typed));
    }
    if (rays.source != RayRequest::Source::PlaneWave)
    {
      throw UsageError("--from-storm and --from-point exclude each other; leave out one of the two");
    }
    rays.source = source;
    rays.sourcePosition = { values[0], values[1] };
  };
  return spec;
}

OptionSpec gravityOption(IncidentWave& wave)
{
  return number(
    "--gravity", "G", "acceleration of gravity, m/s2", "9.81", "Incident wave", wave.gravity, PositiveNumber);
}

OptionSpec edgeOption(TraceOptions& trace)
{
  return choice("--edge", "refraction between offshore and the edge of the grid", "contours", "Rays", trace.edge,
    std::vector<std::pair<std::string, EdgeRule>>{
      { "contours", EdgeRule::Contours }, { "edge", EdgeRule::Edge }, { "none", EdgeRule::None } });
}

OptionSpec shoreNormalOption(TraceOptions& trace)
{
  return number("--shore-normal", "DEG", "direction the offshore contours face, degrees", "from the scene", "Rays",
    trace.shoreNormal, Degrees);
}

std::vector<OptionSpec> tracingOptions(TraceOptions& trace)
{
  const char* group = "Rays";
  OptionSpec lee = choice("--lee-rays", "insert rays in the lee of the shore, a model of diffraction", "on", group,
    trace.leeRays, std::vector<std::pair<std::string, bool>>{ { "on", true }, { "off", false } });
  OptionSpec maxRays{ "--max-rays", "N", "cap on the number of rays", fmt::format("{}", trace.maxRays), group, false,
    {} };
  maxRays.set = [&trace](const std::string& typed)
  { trace.maxRays = static_cast<std::size_t>(parseWhole("--max-rays", typed, 1, 100'000'000)); };
  OptionSpec maxFronts{ "--max-fronts", "N", "cap on the number of fronts", fmt::format("{}", trace.maxFronts), group,
    false, {} };
  maxFronts.set = [&trace](const std::string& typed)
  { trace.maxFronts = static_cast<std::size_t>(parseWhole("--max-fronts", typed, 1, 100'000'000)); };
  return {
    number("--spacing", "M", "distance of the rays along the incident crest, m", "from the scene", group, trace.spacing,
      PositiveMetres),
    number("--max-spacing", "M", "insert a ray where two are further apart, m", "1.5 times the spacing", group,
      trace.maxSpacing, PositiveMetres),
    number("--steps-per-wave", "N", "fronts a wavelength", "8, or as the scene allows", group, trace.stepsPerWave,
      PositiveNumber),
    number("--step", "M", "fronts of equal length instead of equal phase, m", "", group, trace.step, PositiveMetres),
    choice("--scheme", "integrate the ray equations, or Snell's law step by step (1997)", "ode", group, trace.scheme,
      std::vector<std::pair<std::string, TraceScheme>>{ { "ode", TraceScheme::Ode }, { "snell", TraceScheme::Snell } }),
    number("--tolerance", "E", "relative error a step of the integrator", "1e-8", group, trace.tolerance, Tolerance),
    number("--flat-height", "M", "waves lower than this get no inserted rays, m", "a tenth of the height", group,
      trace.flatHeight, NonNegativeMetres),
    choice("--insert", "how inserted rays are made", "retrace", group, trace.insertion,
      std::vector<std::pair<std::string, InsertionRule>>{ { "retrace", InsertionRule::Retrace },
        { "interpolate", InsertionRule::Interpolate }, { "none", InsertionRule::None } }),
    lee,
    edgeOption(trace),
    shoreNormalOption(trace),
    number("--aground-depth", "M", "depth at which a ray is aground, m", "5 % of the height", group, trace.agroundDepth,
      PositiveMetres),
    maxRays,
    maxFronts,
  };
}

OptionSpec currentOption(RayRequest& rays)
{
  OptionSpec spec = text("--current", "FILE|NAME:key=value,...",
    "steady current: a raster or .vti with u and v, or a built-in jet, shear or eddy", "still water", "Rays",
    rays.current);
  const auto setName = spec.set;
  spec.set = [setName](const std::string& typed)
  {
    setName(typed);
    std::error_code none;
    if (isBuiltinCurrent(typed) || (!std::filesystem::exists(typed, none) && resemblesBuiltinCurrent(typed)))
    {
      try
      {
        makeBuiltinCurrent(typed);
      }
      catch (const std::invalid_argument& error)
      {
        throw UsageError(fmt::format("--current: {}", error.what()));
      }
    }
  };
  return spec;
}

std::vector<OptionSpec> obstacleOptions(RayRequest& rays)
{
  const char* group = "Obstacles";
  OptionSpec most{ "--max-reflections", "N", "how often one wave is reflected at most", "10", group, false, {} };
  most.set = [&rays](const std::string& typed)
  { rays.maxReflections = static_cast<int>(parseWhole("--max-reflections", typed, 0, 1000)); };
  return {
    text("--obstacles", "FILE", "walls that rays stop at: polygons and lines, .geojson .gpkg .shp", "", group,
      rays.obstacles),
    number("--reflection", "R", "height that a wall reflects, as a share; its property 'reflection' goes first", "0",
      group, rays.reflection, Share),
    most,
  };
}

// A factor, or the word laminar with a viscosity.
OptionSpec frictionOption(HeightOptions& height, const char* group)
{
  OptionSpec spec{ "--friction", "FW|laminar[:NU]",
    "bottom friction factor of Jonsson; laminar: smooth bed of a small tank, water of NU m2/s", "0; NU 1e-6", group,
    false, {} };
  spec.set = [&height](const std::string& typed)
  {
    const std::string word = typed.substr(0, typed.find(':'));
    const bool laminar = word == "laminar";
    if (!laminar && !word.empty() && std::isalpha(static_cast<unsigned char>(word.front())))
    {
      throw UsageError(fmt::format("--friction must be a number of 0 or more, laminar or laminar:NU, not '{}'", typed));
    }
    height.friction = laminar ? 0.0 : parseNumber("--friction", typed, NonNegativeNumber);
    height.viscosity = laminar ? WaterViscosity : 0.0;
    if (laminar && typed != word)
    {
      height.viscosity = parseNumber("--friction laminar", typed.substr(word.size() + 1), PositiveNumber);
    }
  };
  return spec;
}

std::vector<OptionSpec> heightOptions(RayRequest& rays)
{
  const char* group = "Heights";
  HeightOptions& height = rays.height;
  return {
    choice("--amplitude", "refraction from the spacing of rays, or the tube equation", "spacing", group,
      height.amplitude,
      std::vector<std::pair<std::string, AmplitudeRule>>{
        { "spacing", AmplitudeRule::Spacing }, { "tube", AmplitudeRule::Tube } }),
    choice("--caustics", "heights at caustics: finite at folds by the Airy function, infinite, or limited by --kr-max",
      "uniform", group, height.caustics,
      std::vector<std::pair<std::string, CausticRule>>{
        { "uniform", CausticRule::Uniform }, { "geometric", CausticRule::Geometric }, { "cap", CausticRule::Cap } }),
    number("--kr-max", "K", "largest refraction coefficient where a caustic is no fold", "3", group, rays.maxRefraction,
      PositiveNumber),
    choice("--breaking", "limit of the height in shallow water", "gamma", group, height.breaking,
      std::vector<std::pair<std::string, BreakingRule>>{ { "none", BreakingRule::None },
        { "gamma", BreakingRule::Gamma }, { "weggel", BreakingRule::Weggel }, { "miche", BreakingRule::Miche },
        { "dally", BreakingRule::Dally }, { "battjes-janssen", BreakingRule::BattjesJanssen },
        { "baldock", BreakingRule::Baldock } }),
    number("--gamma", "G", "breaker index: height over depth",
      "0.78; battjes-janssen: by the steepness; baldock: by the kh of each place", group, height.gamma, PositiveNumber),
    frictionOption(height, group),
  };
}

bool sameFile(const std::string& a, const std::string& b)
{
  namespace fs = std::filesystem;
  return fs::weakly_canonical(fs::absolute(a)) == fs::weakly_canonical(fs::absolute(b));
}

}

std::vector<OptionSpec> seafloorOptions(SeafloorOptions& seafloor)
{
  const char* group = "Seafloor";
  OptionSpec crop{ "--crop", "X0,Y0,X1,Y1", "keep this rectangle, in the grid's own coordinates", "", group, false,
    {} };
  crop.set = [&seafloor](const std::string& typed)
  {
    const auto values = parseNumbers("--crop", typed, PlainNumber);
    if (values.size() != 4 || values[0] >= values[2] || values[1] >= values[3])
    {
      throw UsageError(fmt::format("--crop needs X0,Y0,X1,Y1 with X0 < X1 and Y0 < Y1, not '{}'", typed));
    }
    seafloor.crop = { values[0], values[1], values[2], values[3] };
  };
  return {
    number("--water-level", "M", "height of the water above the file's zero (tide), m", "0", group, seafloor.waterLevel,
      Metres),
    choice("--positive", "sign of the file's values: elevation (up) or depth (down)", "auto", group, seafloor.positive,
      std::vector<std::pair<std::string, Positive>>{
        { "auto", Positive::Auto }, { "up", Positive::Up }, { "down", Positive::Down } }),
    text("--crs", "CRS", "coordinate reference system of the file, as EPSG:28992, WKT or 'local'", "as the file says",
      group, seafloor.crs),
    crop,
    number("--resample", "M", "resample to this spacing, m", "soundings: about their distance", group,
      seafloor.resample, PositiveMetres),
    number("--smooth", "M", "smooth by a Gaussian of this standard deviation, m", "0", group, seafloor.smooth,
      NonNegativeMetres),
    number(
      "--nodata", "V", "value that marks cells without data", "as the file says", group, seafloor.nodata, PlainNumber),
    text("--variable", "NAME", "variable of a NetCDF file, raster band, or column of a table", "the first that fits",
      group, seafloor.variable),
    number("--max-gap", "M", "fill gaps up to this width, m; soundings: make holes this far from them",
      "5 cells; soundings: from their distance", group, seafloor.maxGap, NonNegativeMetres),
    flag("--drop-outliers", "leave out soundings far off their neighbours", group, seafloor.dropOutliers),
    choice("--earth", "of a grid in longitude and latitude: a plane map, or the ellipsoid, for whole basins", "plane",
      group, seafloor.earth,
      std::vector<std::pair<std::string, EarthModel>>{
        { "plane", EarthModel::Plane }, { "ellipsoid", EarthModel::Ellipsoid } }),
  };
}

std::vector<OptionSpec> waveOptions(RayRequest& rays, bool required)
{
  const char* group = "Incident wave";
  IncidentWave& wave = rays.wave;
  OptionSpec period = number("--period", "S", "wave period, s", "", group, wave.period, PositiveSeconds);
  const auto setPeriod = period.set;
  period.set = [setPeriod, &rays](const std::string& typed)
  {
    setPeriod(typed);
    rays.wanted = true;
  };
  OptionSpec direction = number("--direction", "DEG",
    "where the waves come from, degrees clockwise from north; or --from-storm, --from-point", "", group,
    wave.directionFrom, Degrees);
  const auto setDirection = direction.set;
  direction.set = [setDirection, &rays](const std::string& typed)
  {
    setDirection(typed);
    rays.directed = true;
  };
  OptionSpec height =
    number("--height", "M", "wave height offshore, crest to trough, m", "", group, wave.height, PositiveMetres);
  period.required = height.required = required;

  return { period, direction,
    sourceOption(
      rays, "--from-storm", "LON,LAT", "a storm far away that the waves come from, degrees", RayRequest::Source::Storm),
    sourceOption(rays, "--from-point", "X,Y",
      "a point of the plane that the waves come from, in the grid's own coordinates", RayRequest::Source::Point),
    height, offshoreDepthOption(wave), gravityOption(wave) };
}

std::vector<OptionSpec> rayOptions(RayRequest& rays)
{
  std::vector<OptionSpec> options = tracingOptions(rays.trace);
  options.push_back(currentOption(rays));
  add(options, obstacleOptions(rays));
  add(options, heightOptions(rays));
  return options;
}

std::vector<OptionSpec> uniformDepthOptions(IncidentWave& wave, const char* group)
{
  OptionSpec depth = offshoreDepthOption(wave, "--depth", "depth of the water, m");
  OptionSpec gravity = gravityOption(wave);
  depth.group = gravity.group = group;
  return { depth, gravity };
}

std::vector<OptionSpec> offshoreOptions(RayRequest& rays)
{
  return { offshoreDepthOption(rays.wave), gravityOption(rays.wave), edgeOption(rays.trace),
    shoreNormalOption(rays.trace), currentOption(rays) };
}

std::vector<OptionSpec> contourOptions(ContourRequest& contour)
{
  OptionSpec levels{ "--levels", "D1,D2,...", "depths of the lines, m", "", "Contours", false, {} };
  levels.set = [&contour](const std::string& typed) { contour.levels = parseNumbers("--levels", typed, Metres); };
  return { levels,
    number("--interval", "M", "a line every so many metres of depth", "about ten lines", "Contours", contour.interval,
      PositiveMetres),
    number("--simplify", "M", "leave out points that matter less than this, m", "0", "Contours", contour.simplify,
      NonNegativeMetres),
    number("--relief", "M", "no lines around ground that departs less than this from their depth, m", "0.02",
      "Contours", contour.relief, NonNegativeMetres) };
}

std::vector<OptionSpec> mapOptions(MapRequest& map)
{
  const char* group = "Maps and stations";
  return { number("--map-spacing", "M", "distance of the nodes of the map, m", "that of the seafloor", group,
             map.spacing, PositiveMetres),
    choice("--combine", "waves of rays that cross: add their energies, or let them interfere", "energy", group,
      map.combine,
      std::vector<std::pair<std::string, CombineRule>>{
        { "energy", CombineRule::Energy }, { "phase", CombineRule::Phase } }) };
}

std::vector<OptionSpec> commonOptions(Request& request)
{
  OptionSpec threads{ "--threads", "N", "threads to use", "all of the machine", "General", false, {} };
  threads.set = [&request](const std::string& typed)
  { request.threads = static_cast<int>(parseWhole("--threads", typed, 1, 1024)); };
  return { threads, flag("--quiet", "no progress and no summary", "General", request.quiet) };
}

void checkRays(RayRequest& rays)
{
  if (rays.directed && rays.source != RayRequest::Source::PlaneWave)
  {
    throw UsageError("--direction is that of a plane wave, a storm or a point gives its own; leave out one of the two");
  }
  if (rays.height.caustics == CausticRule::Geometric && rays.maxRefraction)
  {
    throw UsageError("--kr-max limits nothing with --caustics geometric; leave out one of the two");
  }
  rays.height.maxRefraction = rays.maxRefraction.value_or(rays.height.maxRefraction);
  try
  {
    rays.height.validate();
  }
  catch (const std::invalid_argument& error)
  {
    throw UsageError(error.what());
  }
  if (rays.obstacles.empty() && (rays.reflection || rays.maxReflections))
  {
    throw UsageError(fmt::format(
      "{} needs --obstacles FILE: the walls that reflect", rays.reflection ? "--reflection" : "--max-reflections"));
  }
  if (!rays.current.empty() && rays.trace.scheme == TraceScheme::Snell)
  {
    throw UsageError("--scheme snell knows no current; leave out --current, or take --scheme ode");
  }
  if (rays.trace.spacing && rays.trace.maxSpacing && *rays.trace.maxSpacing < *rays.trace.spacing)
  {
    throw UsageError(fmt::format(
      "--max-spacing must be at least --spacing, {:g} metres, not {:g}", *rays.trace.spacing, *rays.trace.maxSpacing));
  }
}

void checkEarth(const Request& request)
{
  if (request.seafloor.options.earth == EarthModel::Ellipsoid && request.rays.trace.scheme == TraceScheme::Snell)
  {
    throw UsageError("--scheme snell knows no ellipsoid; leave out --earth ellipsoid, or take --scheme ode");
  }
}

void checkPlane(const Request& request, const char* command)
{
  if (request.seafloor.options.earth == EarthModel::Ellipsoid)
  {
    throw UsageError(fmt::format("{} works on a plane; leave out --earth ellipsoid", command));
  }
}

void checkContours(const ContourRequest& contour)
{
  if (!contour.levels.empty() && contour.interval)
  {
    throw UsageError("--levels and --interval exclude each other; leave out one of the two");
  }
}

void checkDifferentFiles(const std::vector<std::pair<std::string, std::string>>& files)
{
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      if (!files[i].second.empty() && !files[j].second.empty() && sameFile(files[i].second, files[j].second))
      {
        throw UsageError(fmt::format("{} and {} name the same file; give two", files[j].first, files[i].first));
      }
    }
  }
}

void checkOutputs(const OutputRequest& output)
{
  checkDifferentFiles(
    { { "--output", output.file }, { "--crests", output.crests }, { "--breaker-line", output.breakerLine },
      { "--map", output.map }, { "--spray", output.spray }, { "--foam", output.foam }, { "--table", output.table },
      { "--spectra", output.spectra }, { "--elevation-series", output.elevations } });
}

}
