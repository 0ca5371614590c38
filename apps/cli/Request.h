#pragma once

#include "Chart.h"

#include "apps/scene/SceneCamera.h"
#include "bathymetry/SeafloorOptions.h"
#include "sim/AmplitudeDispersion.h"
#include "sim/IncidentWave.h"
#include "sim/RayMap.h"
#include "sim/SpectralSea.h"
#include "sim/WaveHeight.h"
#include "sim/WaveTracer.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swellray::cli
{

/** The seafloor and how to read it. */
struct SeafloorRequest
{
  std::string source; ///< a file or NAME:key=value,...
  SeafloorOptions options;
};

/** Which depths get a contour line; neither: none asked for. */
struct ContourRequest
{
  std::vector<double> levels;     ///< depths, m
  std::optional<double> interval; ///< m
  double simplify = 0.0;          ///< m
  double relief = 0.02;           ///< m
};

/** Everything that rays depend on. */
struct RayRequest
{
  bool wanted = false; ///< a period was given
  IncidentWave wave;
  bool directed = false; ///< a direction was given
  enum class Source
  {
    PlaneWave, ///< from its direction
    Storm,     ///< longitude and latitude, degrees
    Point,     ///< x and y in the grid's own coordinates
  } source = Source::PlaneWave;
  std::array<double, 2> sourcePosition{ 0.0, 0.0 };
  TraceOptions trace;
  std::string current;               ///< a file or NAME:key=value,...; empty: still water
  std::string obstacles;             ///< a file; empty: none
  std::optional<double> reflection;  ///< of obstacles that have none of their own
  std::optional<int> maxReflections; ///< of one wave
  HeightOptions height;
  std::optional<double> maxRefraction; ///< the cap where one was given
};

/** Where rays start, in place of the edges of the scene. */
struct StartRequest
{
  std::string launch;                        ///< file of lines or points; empty: none
  std::optional<std::array<double, 2>> site; ///< from which rays are followed back, in the grid's own coordinates
  std::optional<int> directions;             ///< at the site
};

/** The waves by the mild-slope equation in place of rays. */
struct MildSlopeRequest
{
  bool wanted = false;
  std::optional<double> nodeSpacing; ///< m; none: from the scene
  std::optional<double> minDepth;    ///< m; none: from the height
  std::optional<double> memory;      ///< GB; none: four fifths of the machine's
  std::optional<double> coastReflection;
  bool sideWalls = false;
  WaveDispersion dispersion = WaveDispersion::Linear;
};

/** Where waves are asked for: on a map, and at stations. */
struct MapRequest
{
  std::optional<double> spacing; ///< of the nodes, m; none: those of the seafloor
  CombineRule combine = CombineRule::Energy;
  std::string stations;    ///< file of points; empty: none
  std::string waterLevels; ///< file of a series of water levels; empty: none
};

/** A sea offshore, and how it is brought to a place. */
struct SpectrumRequest
{
  std::optional<double> height;     ///< Hs, m
  std::optional<double> peakPeriod; ///< s
  std::optional<double> directionFrom;
  double spread = 25.0; ///< degrees
  SpectrumShape shape = SpectrumShape::Jonswap;
  double peakedness = StandardPeakedness;
  std::optional<double> wind;                          ///< m/s
  std::optional<double> fetch;                         ///< m
  std::string boundary;                                ///< spectral file; empty: none
  std::string series;                                  ///< file of seas in time; empty: none
  std::string transfer;                                ///< file that keeps the rays; empty: none
  std::optional<std::array<double, 2>> frequencyRange; ///< Hz; none: from the sea
  int frequencies = 20;
  int directions = 36;
  int raysPerDirection = 1;
  double tolerance = 1e-5;
  BreakingRule breaking = BreakingRule::Gamma;
  std::optional<double> gamma; ///< largest Hs over depth, or breaker index
  double friction = 0.0;       ///< m2/s3
};

/** Surface elevation in time at stations. */
struct ElevationRequest
{
  double duration = 1200.0; ///< s
  double interval = 0.5;    ///< s
  int seed = 1;
};

/** In place of a file of crest lines: make them from the rays that are drawn. */
constexpr const char* CrestsFromRays = "auto";

/** Times from first to last, so many seconds apart. */
struct TimeSeries
{
  double first = 0.0;
  double last = 0.0;
  double step = 1.0;

  /** A length that is whole steps but for rounding keeps its last. */
  std::size_t count() const
  {
    constexpr double rounding = 1e-9;
    return static_cast<std::size_t>(std::floor((this->last - this->first) / this->step + rounding)) + 1;
  }

  double at(std::size_t i) const { return this->first + static_cast<double>(i) * this->step; }
};

/** What a picture is. */
enum class PictureStyle
{
  Chart,
  Scene,   ///< the water in three dimensions
  Section, ///< the water and the bed along a line
};

/** How finely the water of a scene is drawn. */
enum class SceneDetail
{
  Auto,   ///< as Waves, or as Screen where rays have more points than can be drawn
  Waves,  ///< by the sheets between the rays
  Screen, ///< where pixels see it
};

/** Look of the picture. */
struct RenderRequest
{
  std::string rays;         ///< file to draw; empty: none
  std::string crests;       ///< file to draw, or CrestsFromRays; empty: none
  std::string map;          ///< file whose field is drawn in place of the depths; empty: none
  std::string mapBy;        ///< its array; empty: the wave height
  std::string colorBy;      ///< of the rays; empty: the wave height, or none over a map
  std::size_t colorMap = 0; ///< of drawing::quantityMaps()
  ChartFrame frame = ChartFrame::Auto;
  std::optional<std::array<int, 2>> size; ///< pixels; none: 1600 wide, as high as the scene asks for
  std::string title;                      ///< empty: name of the seafloor
  PictureStyle style = PictureStyle::Chart;
  std::optional<scene::CameraName> camera;
  std::optional<std::array<double, 6>> cameraPlace; ///< eye and focus, in the grid's own coordinates and m
  std::optional<std::array<double, 2>> sun;         ///< azimuth, nautical, and elevation, degrees
  std::optional<double> time;                       ///< s
  std::optional<TimeSeries> times;                  ///< frames of a movie
  SceneDetail detail = SceneDetail::Auto;
  int sheet = 0;                             ///< frames a row of one picture of all of them; 0: one picture each
  std::vector<std::string> profiles;         ///< a section each; empty: that of the surface
  std::optional<std::array<double, 4>> line; ///< of sections: from and to, in the grid's own coordinates
  std::optional<double> exaggeration;        ///< of their heights
  bool sceneOnly = false;                    ///< an option of scenes was given
  bool seaOnly = false;                      ///< an option of scenes and sections was given
};

/** The interactive window. */
struct ViewRequest
{
  bool partial = false;                 ///< a direction or a height was given
  std::array<int, 2> size{ 1280, 800 }; ///< pixels
};

/** Which cases of known answer are run. */
struct ValidateRequest
{
  std::vector<std::string> cases; ///< names or their beginnings; empty: all
  bool list = false;
  bool quick = false;
  std::string report;   ///< folder; empty: none
  double perturb = 0.0; ///< share by which a formula is made wrong
  enum class Formula
  {
    Dispersion, ///< by gravity
    Bending,    ///< of rays, by the slope of the bed
    Tube,       ///< its equation, by the curvature of the bed
  } perturbed = Formula::Dispersion;
};

/** The breaking-wave surface and its times. */
struct SurfaceRequest
{
  std::string profile = "gonzato-lesaec"; ///< vertical section, NAME:key=value,...
  bool straightPhase = false;             ///< Peachey's, in place of the traced one
  std::optional<double> time;             ///< s
  std::optional<TimeSeries> times;        ///< frames of a series
  std::optional<double> pointsPerWave;    ///< none: as many as the section asks for
  std::optional<double> foamLife;         ///< s
  std::optional<int> pixelStep;           ///< of a camera's samples; its place and picture are RenderRequest's
  std::optional<double> foamSpacing;      ///< of the nodes of its grid, m; none: the seafloor's
  int seed = 1;
  std::optional<double> groupWaves;     ///< a group; none: all are alike
  std::optional<double> groupLull;      ///< height of the lowest over that of the highest
  std::vector<IncidentWave> components; ///< further waves of the sea: period, direction and height
  std::optional<double> sprayRate;      ///< particles a metre of crest and metre
  std::optional<double> spraySteepness; ///< H/L from which on crests throw; none: as the trace breaks
  std::string at;                       ///< file of places and times; empty: none
};

/** The output that is made again. */
struct AgainRequest
{
  std::string file;
  std::string folder; ///< for the outputs; empty: where they were
  bool show = false;  ///< only print how it was made
};

/** What the program writes about itself. */
struct ManualRequest
{
  std::string shell;  ///< whose completion
  std::string folder; ///< for the pages
  bool markdown = false;
};

/** How the directions of a sea surface spread. */
enum class SeaSpreading
{
  Hasselmann,    ///< Hasselmann et al. 1980
  Thon,          ///< Thon et al. 2000
  CosinePower,   ///< of the spread given
  WrappedNormal, ///< of the spread given
};

/** A patch of sea surface, and what is made of it. */
struct SeaRequest
{
  std::optional<double> spread;          ///< degrees
  std::optional<SeaSpreading> spreading; ///< none: Hasselmann, or the cosine power where a spread is given
  double size = 200.0;                   ///< side of the patch, m
  std::optional<double> spacing;         ///< of the mesh, m; none: 256 points a side
  std::optional<double> time;            ///< s
  std::optional<TimeSeries> times;       ///< frames of a series
  int components = 64;
  double sharpness = 1.0;
  bool turbulence = true;
  bool tile = false;
  int seed = 1;
  std::string heightImage; ///< files; empty: none
  std::string normalImage;
  std::string picture;
  int pixels = 512; ///< a side of the images
  std::array<int, 2> pictureSize{ 800, 450 };
  double eyeHeight = 8.0;              ///< m above the mean level
  std::optional<double> lookDirection; ///< where to, degrees from north; none: towards the waves
};

/** Files to write; empty: not asked for. */
struct OutputRequest
{
  std::string file;
  std::string crests;
  std::string breakerLine;
  std::string spray;
  std::string foam;  ///< on a grid
  std::string scene; ///< for others to draw
  std::string map;
  std::string table;      ///< waves at the stations
  std::string spectra;    ///< spectra at the stations
  std::string elevations; ///< surface elevation at the stations in time
  bool compress = false;
  bool points = false; ///< in a .gpkg the points of lines too
};

/** One call of the program, checked. */
struct Request
{
  SeafloorRequest seafloor;
  ContourRequest contour;
  RayRequest rays;
  StartRequest start;
  MapRequest map;
  SpectrumRequest spectrum;
  ElevationRequest elevation;
  SeaRequest sea;
  MildSlopeRequest mildSlope;
  RenderRequest render;
  ViewRequest view;
  SurfaceRequest surface;
  ValidateRequest validate;
  AgainRequest again;
  ManualRequest manual;
  OutputRequest output;
  bool json = false;
  bool planOnly = false; ///< only say what the work will take
  bool quiet = false;
  int threads = 0;         ///< 0: as many as the machine has
  std::string commandLine; ///< as typed, for the files

  /** What sets a case of a sweep apart: the options that are varied and their values. Empty: no sweep. */
  std::vector<std::pair<std::string, std::string>> variation;
};

}
