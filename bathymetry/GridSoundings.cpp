#include "bathymetry/GridSoundings.h"

#include "bathymetry/CellCover.h"
#include "bathymetry/FileGrid.h"
#include "bathymetry/GridLayout.h"
#include "bathymetry/InscribedRectangle.h"
#include "bathymetry/NaturalNeighbours.h"
#include "bathymetry/SoundingErrors.h"
#include "bathymetry/SoundingPlaces.h"
#include "bathymetry/Text.h"
#include "bathymetry/ToMetres.h"
#include "sim/EllipsoidMercator.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace swellray
{

namespace
{

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

// On a square lattice of soundings this closes gaps five of its cells wide, as on a raster.
constexpr double GapOverRadius = 3.5355339059327378; // 5/sqrt(2)

// Triangles so much larger than most span bays of the outline, not gaps of the survey.
constexpr double RadiusOfBays = 20.0;

// A spacing that nobody asked for makes no more nodes than this.
constexpr double NodesUnasked = 4e6;

// Points on each side of a crop in longitude and latitude.
constexpr int PointsOfSide = 64;

void reportProgress(const Execution& execution, double share)
{
  if (!execution.report(share))
  {
    throw std::runtime_error("gridding was cancelled");
  }
}

// Radius of the circles of the triangles in the middle of the area, the smaller half of which lies in smaller ones.
double usualRadius(std::vector<NaturalNeighbours::Triangle>& triangles)
{
  const auto smaller = [](const auto& a, const auto& b) { return a.radius < b.radius; };
  std::sort(triangles.begin(), triangles.end(), smaller);
  const double largest = RadiusOfBays * triangles[triangles.size() / 2].radius;
  double area = 0.0;
  for (const auto& triangle : triangles)
  {
    area += triangle.radius <= largest ? triangle.area : 0.0;
  }
  double sum = 0.0;
  for (const auto& triangle : triangles)
  {
    sum += triangle.area;
    if (sum >= 0.5 * area)
    {
      return triangle.radius;
    }
  }
  return triangles.back().radius;
}

double twoDigits(double length)
{
  const double unit = std::pow(10.0, std::floor(std::log10(length)) - 1.0);
  return std::round(length / unit) * unit;
}

// Cells by the places of their corners; a NaN corner makes its cells cover nothing.
struct Cells
{
  std::vector<glm::dvec2> corners;
  std::vector<std::size_t> offsets;
  std::vector<std::uint32_t> nodes;
};

class Gridder
{
public:
  Gridder(const Soundings& soundings, const SeafloorOptions& options, const Execution& execution)
    : Input(soundings)
    , Options(options)
    , Run(execution)
  {
  }

  GriddedSoundings grid();

private:
  void place();
  void measureDistances(const NaturalNeighbours& neighbours);
  void judge(NaturalNeighbours& neighbours);
  void layOut();
  void interpolate(const NaturalNeighbours& neighbours);
  Rectangle wantedBox() const;
  void requireSize(const Rectangle& box) const;
  Cells cells(const std::vector<glm::dvec2>& places) const;
  bool onEllipsoid() const { return this->Options.earth == EarthModel::Ellipsoid; }

  const Soundings& Input;
  const SeafloorOptions& Options;
  const Execution& Run;
  SoundingPlaces Places;
  std::vector<glm::dvec2> Points; // of the places, m
  std::vector<bool> Dropped;      // of the places
  GriddedSoundings Result;
};

void Gridder::place()
{
  this->Places = findPlaces(this->Input, this->Options, this->Result.report);
  const Rectangle& extent = this->Places.extent;
  const std::optional<std::array<double, 4>>& crop = this->Options.crop;
  glm::dvec2 low = extent.low;
  glm::dvec2 middle = 0.5 * (extent.low + extent.high);
  if (crop)
  {
    low = glm::max(low, glm::dvec2((*crop)[0], (*crop)[1]));
    middle = 0.5 * glm::dvec2((*crop)[0] + (*crop)[2], (*crop)[1] + (*crop)[3]);
  }
  const glm::dvec2 origin(std::remainder(middle.x, 360.0), std::clamp(middle.y, -90.0, 90.0));
  this->Result.georeference = Georeference(this->Places.crs.crs, origin, low);
  if (this->onEllipsoid() && this->Result.georeference.kind() != GeoreferenceKind::Geographic)
  {
    throw std::runtime_error("on the ellipsoid soundings must be in longitude and latitude; trace these on the plane "
                             "(earth plane), or bring them to longitude and latitude first (ogr2ogr -t_srs EPSG:4326)");
  }
  if (this->Result.georeference.kind() == GeoreferenceKind::Geographic)
  {
    const std::string coordinates = "its coordinates, " + text(extent.low.x, 9) + " to " + text(extent.high.x, 9) +
      " and " + text(extent.low.y, 9) + " to " + text(extent.high.y, 9) + ",";
    if (std::abs(extent.low.y) > 90.0 || std::abs(extent.high.y) > 90.0)
    {
      throw std::runtime_error(coordinates + " are no longitude and latitude, as CRS '" +
        this->Result.georeference.crsName() + "' would have them; say --crs");
    }
    if (this->onEllipsoid())
    {
      constexpr double largest = EllipsoidMercator::LargestLatitude;
      if (extent.low.y < -largest || extent.high.y > largest)
      {
        throw std::runtime_error(
          coordinates + " reach beyond latitude " + text(largest) + " on the ellipsoid; leave these soundings out");
      }
      this->Result.georeference = Georeference::onEllipsoid(this->Places.crs.crs, origin.x, origin.y);
    }
    else if (extent.size().x > WidestScene || extent.size().y > WidestScene)
    {
      throw std::runtime_error(coordinates + " span more than " + text(WidestScene) +
        " degrees, too much for one plane map; use --crop, or --earth ellipsoid");
    }
  }
  this->Points.resize(this->Places.file.size());
  this->Result.georeference.fromFile(this->Points.size(), this->Places.file.data(), this->Points.data());
}

// `places` are those of the soundings, in metres or in file coordinates; so are the corners then.
Cells Gridder::cells(const std::vector<glm::dvec2>& places) const
{
  Cells cells{ {}, this->Input.cellOffsets, this->Input.cellNodes };
  const auto hasData = [this](std::size_t sounding)
  { return this->Places.placeOf[sounding] != SoundingPlaces::NoPlace; };
  if (this->Input.cornerX.empty())
  {
    cells.corners.assign(this->Input.size(), glm::dvec2(NotANumber));
    for (std::size_t node = 0; node < cells.corners.size(); ++node)
    {
      if (hasData(node))
      {
        cells.corners[node] = places[this->Places.placeOf[node]];
      }
    }
    return cells;
  }
  const std::size_t count = this->Input.cornerX.size();
  const Georeference& place = this->Result.georeference;
  const bool degrees = place.kind() == GeoreferenceKind::Geographic;
  const double middle = 0.5 * (this->Places.extent.low.x + this->Places.extent.high.x);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = this->Input.cornerX[i];
    cells.corners.emplace_back(degrees ? middle + std::remainder(x - middle, 360.0) : x, this->Input.cornerY[i]);
  }
  if (&places == &this->Points)
  {
    place.fromFile(count, cells.corners.data(), cells.corners.data());
  }
  cells.offsets.assign(1, 0);
  cells.nodes.clear();
  for (std::size_t cell = 0; cell < this->Input.size(); ++cell)
  {
    if (hasData(cell))
    {
      const auto first = this->Input.cellNodes.begin();
      cells.nodes.insert(cells.nodes.end(), first + static_cast<std::ptrdiff_t>(this->Input.cellOffsets[cell]),
        first + static_cast<std::ptrdiff_t>(this->Input.cellOffsets[cell + 1]));
      cells.offsets.push_back(cells.nodes.size());
    }
  }
  return cells;
}

void Gridder::measureDistances(const NaturalNeighbours& neighbours)
{
  SoundingReport& report = this->Result.report;
  std::vector<NaturalNeighbours::Triangle> triangles = neighbours.triangles();
  if (triangles.empty())
  {
    throw std::runtime_error(
      "its " + std::to_string(this->Points.size()) + " soundings lie on one line: no seafloor can be made of them");
  }
  const double radius = usualRadius(triangles);
  const double gap = GapOverRadius * radius;
  report.patch = std::sqrt(2.0) * radius;
  const bool cells = !this->Input.cellOffsets.empty();
  report.cells = cells ? this->Input.cellOffsets.size() - 1 : 0;
  report.maxGapChosen = !this->Options.maxGap && !cells;
  report.maxGap = this->Options.maxGap.value_or(cells ? std::numeric_limits<double>::infinity() : gap);

  double area = 0.0;
  if (cells)
  {
    const Cells all = this->cells(this->Points);
    area = cellArea(all.corners, all.offsets, all.nodes);
  }
  else
  {
    for (const auto& triangle : triangles)
    {
      area += triangle.radius <= gap ? triangle.area : 0.0;
    }
  }
  report.meanDistance = std::sqrt(area / static_cast<double>(this->Points.size()));
  report.spacingChosen = !this->Options.resample;
  report.spacing = this->Options.resample.value_or(0.0);
  if (!(report.meanDistance > 0.0))
  {
    throw std::runtime_error("its cells cover nothing: a node without a value in each");
  }
  if (report.spacingChosen)
  {
    report.spacing = twoDigits(report.meanDistance);
    if (this->Input.spacing)
    {
      const Georeference& place = this->Result.georeference;
      const glm::dvec2 middle = 0.5 * (this->Places.extent.low + this->Places.extent.high);
      const glm::dvec2 step = place.fromFile(middle + glm::dvec2(0.0, *this->Input.spacing)) - place.fromFile(middle);
      report.spacing = twoDigits(std::hypot(step.x, step.y));
    }
  }
}

// Outliers and errors of what the soundings foretell of each other.
void Gridder::judge(NaturalNeighbours& neighbours)
{
  SoundingReport& report = this->Result.report;
  LeftOutDifferences differences = leftOutDifferences(neighbours, this->Places.elevation, this->Run);
  const std::vector<double> all = differences.elevation;
  const std::vector<std::uint32_t> outliers = takeOutliers(neighbours, this->Places.elevation, differences);
  this->Dropped.assign(this->Points.size(), false);
  report.outliers = outliers.size();
  report.outliersDropped = this->Options.dropOutliers && !outliers.empty();
  for (const std::uint32_t place : outliers)
  {
    if (std::abs(all[place]) > report.worstOutlier)
    {
      report.worstOutlier = std::abs(all[place]);
      report.worstOutlierPlace = this->Places.file[place];
    }
    if (report.outliersDropped)
    {
      this->Dropped[place] = true;
    }
    else
    {
      neighbours.restore(place, this->Points[place]);
    }
  }
  report.used = this->Points.size() - (report.outliersDropped ? outliers.size() : 0);
  report.single = summarize(report.outliersDropped ? differences.elevation : all, this->Places.file);
  if (this->Options.crossValidate)
  {
    std::vector<glm::dvec2> points;
    std::vector<glm::dvec2> file;
    std::vector<double> elevations;
    for (std::size_t place = 0; place < this->Points.size(); ++place)
    {
      if (!this->Dropped[place])
      {
        points.push_back(this->Points[place]);
        file.push_back(this->Places.file[place]);
        elevations.push_back(this->Places.elevation[place]);
      }
    }
    report.tenth = summarize(tenthDifferences(points, elevations, report.patch, this->Run), file);
  }
}

// Metres, or degrees on the ellipsoid.
Rectangle Gridder::wantedBox() const
{
  if (this->onEllipsoid())
  {
    Rectangle box = this->Places.extent;
    if (const auto& crop = this->Options.crop)
    {
      const double turn =
        360.0 * std::round((0.5 * (box.low.x + box.high.x) - 0.5 * ((*crop)[0] + (*crop)[2])) / 360.0);
      box.low = glm::max(box.low, glm::dvec2((*crop)[0] + turn, (*crop)[1]));
      box.high = glm::min(box.high, glm::dvec2((*crop)[2] + turn, (*crop)[3]));
    }
    this->requireSize(box);
    return box;
  }
  const Georeference& place = this->Result.georeference;
  Rectangle box{ this->Points.front(), this->Points.front() };
  for (const glm::dvec2& point : this->Points)
  {
    box.low = glm::min(box.low, point);
    box.high = glm::max(box.high, point);
  }
  if (!this->Options.crop)
  {
    return box;
  }
  const std::array<double, 4>& crop = *this->Options.crop;
  const glm::dvec2 corners[] = { { crop[0], crop[1] }, { crop[2], crop[1] }, { crop[2], crop[3] }, { crop[0], crop[3] },
    { crop[0], crop[1] } };
  std::vector<glm::dvec2> outline;
  for (int side = 0; side < 4; ++side)
  {
    for (int i = 0; i < PointsOfSide; ++i)
    {
      const double share = static_cast<double>(i) / PointsOfSide;
      outline.push_back(place.fromFile((1.0 - share) * corners[side] + share * corners[side + 1]));
    }
  }
  const Rectangle wanted = inscribedRectangle(outline);
  box.low = glm::max(box.low, wanted.low);
  box.high = glm::min(box.high, wanted.high);
  this->requireSize(box);
  return box;
}

void Gridder::requireSize(const Rectangle& box) const
{
  if (!(box.low.x < box.high.x && box.low.y < box.high.y))
  {
    const Rectangle& extent = this->Places.extent;
    throw std::runtime_error("crop lies outside of its soundings, whose extent is " + text(extent.low.x, 9) + "," +
      text(extent.low.y, 9) + "," + text(extent.high.x, 9) + "," + text(extent.high.y, 9));
  }
}

void Gridder::layOut()
{
  SoundingReport& report = this->Result.report;
  const Rectangle box = this->wantedBox();
  const Georeference& place = this->Result.georeference;
  // Metres a degree in the middle; the map of the ellipsoid is true to scale there.
  const glm::dvec2 middle = 0.5 * (box.low + box.high);
  glm::dvec2 unit(1.0);
  if (this->onEllipsoid())
  {
    constexpr double half = 0.05; // degrees
    const double scale = place.scale(place.fromFile(middle));
    unit.x = (place.fromFile(middle + glm::dvec2(half, 0.0)).x - place.fromFile(middle - glm::dvec2(half, 0.0)).x) /
      (2.0 * half * scale);
    unit.y = (place.fromFile(middle + glm::dvec2(0.0, half)).y - place.fromFile(middle - glm::dvec2(0.0, half)).y) /
      (2.0 * half * scale);
  }
  if (report.spacingChosen)
  {
    const double least = std::sqrt(box.size().x * unit.x * box.size().y * unit.y / NodesUnasked);
    if (report.spacing < least)
    {
      report.spacing = twoDigits(least);
      this->Places.notes.push_back("gridded " + text(report.spacing) + " m apart, coarser than its soundings are (" +
        text(report.meanDistance, 3) + " m), for " + text(NodesUnasked / 1e6) +
        " million nodes; choose another spacing with --resample");
    }
  }
  const bool geographic = place.kind() == GeoreferenceKind::Geographic;
  this->Result.grid = layOutGrid(box, report.spacing / unit, geographic);
  if (geographic && !this->onEllipsoid())
  {
    this->Result.scaleError = largestScaleError(this->Result.grid.bounds(), place);
  }
}

void Gridder::interpolate(const NaturalNeighbours& neighbours)
{
  ElevationGrid& grid = this->Result.grid;
  const Georeference& place = this->Result.georeference;
  const double maxGap = this->Result.report.maxGap;
  std::vector<bool> covered;
  if (this->Result.report.cells > 0)
  {
    const Cells all = this->cells(this->onEllipsoid() ? this->Places.file : this->Points);
    covered = cellCover(grid, all.corners, all.offsets, all.nodes);
  }
  this->Run.forRange(grid.rows,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t row = begin; row < end; ++row)
      {
        // Each row searches from the start, so that how rows are shared out changes nothing.
        NaturalNeighbours::Walk walk(neighbours);
        for (std::size_t column = 0; column < grid.columns; ++column)
        {
          double& elevation = grid.at(column, row);
          elevation = NotANumber;
          if (!covered.empty() && !covered[row * grid.columns + column])
          {
            continue;
          }
          const glm::dvec2 node = grid.node(column, row);
          const glm::dvec2 point = this->onEllipsoid() ? place.fromFile(node) : node;
          const NaturalNeighbours::Estimate estimate = walk.at(point, this->Places.elevation);
          if (estimate.distance <= (this->onEllipsoid() ? maxGap * place.scale(point) : maxGap))
          {
            elevation = estimate.value;
          }
        }
      }
    });
  this->Result.report.holes = static_cast<std::size_t>(std::count_if(
    grid.elevation.begin(), grid.elevation.end(), [](double elevation) { return std::isnan(elevation); }));
  if (this->Result.report.holes == grid.elevation.size())
  {
    throw std::runtime_error("no node of the grid has a sounding within max-gap (" + text(maxGap, 3) + " m)");
  }
}

GriddedSoundings Gridder::grid()
{
  this->place();
  reportProgress(this->Run, 0.1);
  NaturalNeighbours neighbours(this->Points);
  reportProgress(this->Run, 0.3);
  this->measureDistances(neighbours);
  this->judge(neighbours);
  reportProgress(this->Run, 0.7);
  this->layOut();
  this->interpolate(neighbours);
  reportProgress(this->Run, 1.0);
  this->Result.meaning = this->Places.meaning;
  this->Result.crsSource = this->Places.crs.source;
  this->Result.fileExtent = this->Places.extent;
  this->Result.notes = this->Places.notes;
  return std::move(this->Result);
}

}

GriddedSoundings gridSoundings(const Soundings& soundings, const SeafloorOptions& options, const Execution& execution)
{
  options.validate();
  return Gridder(soundings, options, execution).grid();
}

}
