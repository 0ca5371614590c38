#include "Options.h"

#include "Failure.h"
#include "Values.h"

#include "sim/BuiltinCurrent.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <utility>

namespace swellray::cli
{

namespace
{

const NumberRule Metres{ "metres" };
const NumberRule PositiveMetres{ "metres", 0.0, 1e300, true };
const NumberRule NonNegativeMetres{ "metres", 0.0 };
const NumberRule PositiveSeconds{ "seconds", 0.0, 1e300, true };
const NumberRule Degrees{ "degrees", -360.0, 360.0 };
const NumberRule PlainNumber{};
const NumberRule PositiveNumber{ "", 0.0, 1e300, true };
const NumberRule NonNegativeNumber{ "", 0.0 };

// A tolerance beyond these either cannot be met in double precision or says nothing.
const NumberRule Tolerance{ "", 1e-14, 1e-2 };

// Enough for any case to notice.
const NumberRule Perturbation{ "", -0.5, 0.5 };

template <typename Target>
OptionSpec number(const char* name, const char* value, const char* help, const char* standard, const char* group,
  Target& target, const NumberRule& rule)
{
  OptionSpec spec{ name, value, help, standard, group, false, {} };
  const std::string longName = spec.longName();
  spec.set = [&target, rule, longName](const std::string& text) { target = parseNumber(longName, text, rule); };
  return spec;
}

template <typename Target, typename Value>
OptionSpec choice(const char* name, const char* help, const char* standard, const char* group, Target& target,
  const std::vector<std::pair<std::string, Value>>& values)
{
  std::vector<std::string> words;
  std::string shown;
  for (const auto& entry : values)
  {
    words.push_back(entry.first);
    shown += (shown.empty() ? "" : "|") + entry.first;
  }
  OptionSpec spec{ name, shown, help, standard, group, false, {} };
  const std::string longName = spec.longName();
  spec.set = [&target, values, words, longName](const std::string& text)
  { target = values[parseChoice(longName, text, words)].second; };
  return spec;
}

OptionSpec text(
  const char* name, const char* value, const char* help, const char* standard, const char* group, std::string& target)
{
  OptionSpec spec{ name, value, help, standard, group, false, {} };
  const std::string longName = spec.longName();
  spec.set = [&target, longName](const std::string& typed)
  {
    if (typed.empty())
    {
      throw UsageError(longName + " needs a value");
    }
    target = typed;
  };
  return spec;
}

OptionSpec flag(const char* name, const char* help, const char* group, bool& target)
{
  return { name, "", help, "", group, false, [&target](const std::string&) { target = true; } };
}

OptionSpec outputFile(const char* name, const char* help, std::string& target, const std::vector<std::string>& endings)
{
  OptionSpec spec{ name, "FILE", help, "", "Output", false, {} };
  const std::string longName = spec.longName();
  spec.set = [&target, longName, endings](const std::string& typed)
  {
    const std::string ending = std::filesystem::path(typed).extension().string();
    for (const std::string& allowed : endings)
    {
      if (ending == allowed)
      {
        target = typed;
        return;
      }
    }
    throw UsageError(fmt::format("{} must end in {}, not '{}'", longName, alternatives(endings), typed));
  };
  return spec;
}

bool sameFile(const std::string& a, const std::string& b)
{
  namespace fs = std::filesystem;
  return fs::weakly_canonical(fs::absolute(a)) == fs::weakly_canonical(fs::absolute(b));
}

void add(std::vector<OptionSpec>& options, std::vector<OptionSpec> more)
{
  for (OptionSpec& option : more)
  {
    options.push_back(std::move(option));
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
    number("--resample", "M", "resample to this spacing, m", "", group, seafloor.resample, PositiveMetres),
    number("--smooth", "M", "smooth by a Gaussian of this standard deviation, m", "0", group, seafloor.smooth,
      NonNegativeMetres),
    number(
      "--nodata", "V", "value that marks cells without data", "as the file says", group, seafloor.nodata, PlainNumber),
    text("--variable", "NAME", "variable of a NetCDF file, or raster band", "the first that fits", group,
      seafloor.variable),
    number("--max-gap", "M", "fill gaps up to this width, m", "5 cells", group, seafloor.maxGap, NonNegativeMetres),
  };
}

std::vector<OptionSpec> waveOptions(IncidentWave& wave, bool& wanted, bool required)
{
  const char* group = "Incident wave";
  OptionSpec period = number("--period", "S", "wave period, s", "", group, wave.period, PositiveSeconds);
  const auto setPeriod = period.set;
  period.set = [setPeriod, &wanted](const std::string& typed)
  {
    setPeriod(typed);
    wanted = true;
  };
  OptionSpec direction = number("--direction", "DEG", "where the waves come from, degrees clockwise from north", "",
    group, wave.directionFrom, Degrees);
  OptionSpec height =
    number("--height", "M", "wave height offshore, crest to trough, m", "", group, wave.height, PositiveMetres);
  period.required = direction.required = height.required = required;

  OptionSpec depth{ "--offshore-depth", "M|deep", "depth in which height and direction are given, m", "deep", group,
    false, {} };
  depth.set = [&wave](const std::string& typed)
  {
    wave.offshoreDepth = typed == "deep" ? std::numeric_limits<double>::infinity()
                                         : parseNumber("--offshore-depth", typed, PositiveMetres);
  };
  return { period, direction, height, depth,
    number("--gravity", "G", "acceleration of gravity, m/s2", "9.81", group, wave.gravity, PositiveNumber) };
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
    choice("--edge", "refraction between offshore and the edge of the grid", "contours", group, trace.edge,
      std::vector<std::pair<std::string, EdgeRule>>{
        { "contours", EdgeRule::Contours }, { "edge", EdgeRule::Edge }, { "none", EdgeRule::None } }),
    number("--shore-normal", "DEG", "direction the offshore contours face, degrees", "from the scene", group,
      trace.shoreNormal, Degrees),
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
    if (isBuiltinCurrent(typed) || (typed.find(':') != std::string::npos && !std::filesystem::exists(typed, none)))
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

std::vector<OptionSpec> heightOptions(RayRequest& rays)
{
  const char* group = "Heights";
  HeightOptions& height = rays.height;
  return {
    choice("--amplitude", "refraction from the spacing of rays, or the tube equation", "spacing", group,
      height.amplitude,
      std::vector<std::pair<std::string, AmplitudeRule>>{
        { "spacing", AmplitudeRule::Spacing }, { "tube", AmplitudeRule::Tube } }),
    choice("--caustics", "heights at caustics: limited by --kr-max, or infinite", "cap", group, rays.geometricCaustics,
      std::vector<std::pair<std::string, bool>>{ { "cap", false }, { "geometric", true } }),
    number("--kr-max", "K", "largest refraction coefficient", "3", group, rays.maxRefraction, PositiveNumber),
    choice("--breaking", "limit of the height in shallow water", "gamma", group, height.breaking,
      std::vector<std::pair<std::string, BreakingRule>>{ { "none", BreakingRule::None },
        { "gamma", BreakingRule::Gamma }, { "weggel", BreakingRule::Weggel }, { "miche", BreakingRule::Miche },
        { "dally", BreakingRule::Dally }, { "battjes-janssen", BreakingRule::BattjesJanssen } }),
    number("--gamma", "G", "breaker index: height over depth", "0.78; battjes-janssen: by the steepness", group,
      height.gamma, PositiveNumber),
    number("--friction", "FW", "bottom friction factor of Jonsson", "0", group, height.friction, NonNegativeNumber),
  };
}

std::vector<OptionSpec> contourOptions(ContourRequest& contour)
{
  OptionSpec levels{ "--levels", "D1,D2,...", "depths of the lines, m", "", "Contours", false, {} };
  levels.set = [&contour](const std::string& typed) { contour.levels = parseNumbers("--levels", typed, Metres); };
  return { levels,
    number("--interval", "M", "a line every so many metres of depth", "about ten lines", "Contours", contour.interval,
      PositiveMetres),
    number("--simplify", "M", "leave out points that matter less than this, m", "0", "Contours", contour.simplify,
      NonNegativeMetres) };
}

CommandSpec infoSpec(Request& request)
{
  CommandSpec spec{ Command::Info, "info", "tell what a seafloor file holds and how it is understood", true, {}, {} };
  spec.options = { flag("--json", "print as JSON", "Output", request.json) };
  add(spec.options, seafloorOptions(request.seafloor.options));
  spec.examples = "  swellray info harbour.tif\n"
                  "  swellray info soundings.nc --positive down --json\n"
                  "  swellray info babbage\n";
  return spec;
}

CommandSpec contourSpec(Request& request)
{
  CommandSpec spec{ Command::Contour, "contour", "draw depth contour lines into a .vtp file", true, {}, {} };
  spec.options = { outputFile("-o,--output", "contour lines, .vtp", request.output.file, { ".vtp" }) };
  spec.options.back().required = true;
  add(spec.options, { flag("--compress", "compress the file (smaller, slower)", "Output", request.output.compress) });
  add(spec.options, contourOptions(request.contour));
  add(spec.options, seafloorOptions(request.seafloor.options));
  spec.examples = "  swellray contour harbour.tif --levels 5,10,20 -o contours.vtp\n"
                  "  swellray contour harbour.tif --interval 2 --simplify 5 -o contours.vtp\n";
  return spec;
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

CommandSpec traceSpec(Request& request)
{
  CommandSpec spec{ Command::Trace, "trace", "trace wave rays over a seafloor: states, directions, heights", true, {},
    {} };
  spec.options = { outputFile("-o,--output", "rays, .vtp", request.output.file, { ".vtp" }),
    outputFile("--crests", "crest lines, .vtp", request.output.crests, { ".vtp" }),
    outputFile("--breaker-line", "lines where waves begin to break, .vtp", request.output.breakerLine, { ".vtp" }),
    outputFile("--map", "wave heights and directions on a grid, .vti, .nc or .tif", request.output.map,
      { ".vti", ".nc", ".tif" }),
    text("--stations", "FILE", "points x,y or lon,lat a line, .csv", "", "Output", request.map.stations),
    outputFile("--table", "waves at the stations, .csv", request.output.table, { ".csv" }),
    flag("--compress", "compress the files (smaller, slower)", "Output", request.output.compress) };
  add(spec.options, waveOptions(request.rays.wave, request.rays.wanted, true));
  add(spec.options, tracingOptions(request.rays.trace));
  spec.options.push_back(currentOption(request.rays));
  add(spec.options, heightOptions(request.rays));
  add(spec.options, mapOptions(request.map));
  add(spec.options, seafloorOptions(request.seafloor.options));
  spec.examples =
    "  swellray trace harbour.tif --period 14 --direction 135 --height 2 -o rays.vtp --crests crests.vtp\n"
    "  swellray trace harbour.tif --period 14 --direction 135 --height 2 --map heights.nc --map-spacing 25\n"
    "  swellray trace harbour.tif --period 14 --direction 135 --height 2 --stations buoys.csv --table waves.csv\n"
    "  swellray trace shoal --period 10 --direction 270 --height 1 --current eddy:U0=1.5,R=400 -o rays.vtp\n"
    "  swellray trace babbage --period 10 --direction 270 --height 1 --spacing 5 -o rays.vtp\n"
    "  swellray trace bar --period 9 --direction 90 --height 1.5 --breaking dally --breaker-line breakers.vtp\n"
    "  swellray trace harbour.nc --water-level 1.2 --period 8 --direction 300 --height 1.5 --amplitude tube -o "
    "rays.vtp\n";
  return spec;
}

CommandSpec listSpec()
{
  CommandSpec spec{ Command::List, "list",
    "list the built-in seafloors and currents with their keys, units and defaults", false, {}, {} };
  spec.examples = "  swellray list\n";
  return spec;
}

CommandSpec renderSpec(Request& request)
{
  CommandSpec spec{ Command::Render, "render", "draw the seafloor, its contour lines and rays as a picture", true, {},
    {} };
  RenderRequest& render = request.render;
  OptionSpec size{ "--size", "WxH", "size of the picture, pixels", "1600 wide, high as the scene asks", "Picture",
    false, {} };
  size.set = [&render](const std::string& typed) { render.size = parseSize("--size", typed); };
  spec.options = { outputFile("-o,--output", "picture, .png or .jpg", request.output.file, { ".png", ".jpg" }), size,
    text("--rays", "FILE", "rays that 'swellray trace' wrote, .vtp", "", "Picture", render.rays),
    text("--crests", "FILE|auto", "crest lines from a file, or made from the rays", "", "Picture", render.crests),
    text("--color-by", "ARRAY", "colour the rays by this array, or 'none'", "WaveHeight", "Picture", render.colorBy),
    text("--title", "TEXT", "heading of the picture", "the seafloor's name", "Picture", render.title) };
  spec.options.front().required = true;
  add(spec.options, contourOptions(request.contour));
  add(spec.options, waveOptions(request.rays.wave, request.rays.wanted, false));
  add(spec.options, tracingOptions(request.rays.trace));
  spec.options.push_back(currentOption(request.rays));
  add(spec.options, heightOptions(request.rays));
  add(spec.options, seafloorOptions(request.seafloor.options));
  spec.examples = "  swellray render harbour.tif --rays rays.vtp --crests crests.vtp -o picture.png\n"
                  "  swellray render harbour.tif --period 14 --direction 135 --height 2 -o picture.png\n"
                  "  swellray render harbour.tif --interval 5 --size 2400x1800 -o chart.png\n"
                  "Where no display is set, an X server in memory (Xvfb) is started for the picture.\n";
  return spec;
}

void checkOutputs(const Request& request)
{
  const OutputRequest& output = request.output;
  if (output.table.empty() != request.map.stations.empty())
  {
    throw UsageError("--stations and --table belong together; give both");
  }
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto& file : { std::make_pair("--output", output.file), std::make_pair("--crests", output.crests),
         std::make_pair("--breaker-line", output.breakerLine), std::make_pair("--map", output.map),
         std::make_pair("--table", output.table) })
  {
    for (const auto& other : files)
    {
      if (!file.second.empty() && sameFile(other.second, file.second))
      {
        throw UsageError(fmt::format("{} and {} name the same file; give two", other.first, file.first));
      }
    }
    if (!file.second.empty())
    {
      files.emplace_back(file);
    }
  }
  if (request.command == Command::Trace && files.empty())
  {
    throw UsageError("trace has nothing to write: give -o FILE.vtp, --crests FILE.vtp, --breaker-line FILE.vtp, --map "
                     "FILE or --table FILE.csv");
  }
  if (!output.breakerLine.empty() && request.rays.height.breaking == BreakingRule::None)
  {
    throw UsageError("--breaker-line needs waves that break; leave out --breaking none");
  }
  if (request.map.spacing && output.map.empty())
  {
    throw UsageError("--map-spacing needs --map FILE");
  }
}

CommandSpec validateSpec(Request& request)
{
  CommandSpec spec{ Command::Validate, "validate", "compute the cases with known answers and say how far off they are",
    false, {}, {} };
  ValidateRequest& validate = request.validate;
  const char* group = "Cases";
  OptionSpec names{ "--case", "NAME", "only cases whose names begin so; may be given several times", "all", group,
    false, {} };
  names.repeatable = true;
  names.set = [&validate](const std::string& typed)
  {
    for (std::size_t from = 0; from <= typed.size();)
    {
      const std::size_t comma = std::min(typed.find(',', from), typed.size());
      if (comma == from)
      {
        throw UsageError("--case needs the name of a case, or its beginning; see 'swellray validate --list'");
      }
      validate.cases.push_back(typed.substr(from, comma - from));
      from = comma + 1;
    }
  };
  spec.options = { names, flag("--list", "name the cases and stop", group, validate.list),
    flag("--quick", "leave out what takes long: under one minute", group, validate.quick),
    number("--perturb", "E", "make gravity wrong by this share, to check the checker: cases must fail", "0", group,
      validate.perturb, Perturbation),
    text("--report", "DIR", "write index.html, a picture and the numbers of each case to this folder", "", "Output",
      validate.report) };
  spec.examples = "  swellray validate\n"
                  "  swellray validate --quick --report report\n"
                  "  swellray validate --case c2_plane --case c4_shoal_gauss\n"
                  "  swellray validate --quick --perturb 1e-3     # must fail: exit code 1\n";
  return spec;
}

}

std::string OptionSpec::longName() const
{
  const auto comma = this->name.rfind(',');
  return comma == std::string::npos ? this->name : this->name.substr(comma + 1);
}

std::vector<CommandSpec> commandSpecs(Request& request)
{
  return { infoSpec(request), contourSpec(request), traceSpec(request), renderSpec(request), validateSpec(request),
    listSpec() };
}

std::vector<OptionSpec> commonOptions(Request& request)
{
  OptionSpec threads{ "--threads", "N", "threads to use", "all of the machine", "General", false, {} };
  threads.set = [&request](const std::string& typed)
  { request.threads = static_cast<int>(parseWhole("--threads", typed, 1, 1024)); };
  return { threads, flag("--quiet", "no progress and no summary", "General", request.quiet) };
}

void checkTogether(Request& request)
{
  RayRequest& rays = request.rays;
  if (rays.geometricCaustics && rays.maxRefraction)
  {
    throw UsageError("--kr-max belongs to --caustics cap; leave out one of the two");
  }
  if (rays.geometricCaustics)
  {
    rays.height.maxRefraction = std::numeric_limits<double>::infinity();
  }
  else if (rays.maxRefraction)
  {
    rays.height.maxRefraction = *rays.maxRefraction;
  }
  try
  {
    rays.height.validate();
  }
  catch (const std::invalid_argument& error)
  {
    throw UsageError(error.what());
  }
  if (!request.contour.levels.empty() && request.contour.interval)
  {
    throw UsageError("--levels and --interval exclude each other; leave out one of the two");
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
  checkOutputs(request);
  if (request.command == Command::Render)
  {
    if (rays.wanted && !request.render.rays.empty())
    {
      throw UsageError("--rays draws rays from a file, --period traces new ones; leave out one of the two");
    }
    if (!rays.wanted && request.render.rays.empty() && request.render.crests == CrestsFromRays)
    {
      throw UsageError("--crests auto needs rays: give --rays FILE, or --period, --direction and --height");
    }
  }
}

}
