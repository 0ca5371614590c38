#include "bathymetry/CalendarTime.h"
#include "bathymetry/GdalOutput.h"
#include "bathymetry/NetcdfArrays.h"
#include "bathymetry/QuietGdal.h"
#include "bathymetry/SpectrumFormats.h"
#include "bathymetry/Text.h"
#include "sim/Angles.h"

#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace swellray
{

using namespace gdaloutput;

namespace
{

using Array = std::shared_ptr<GDALMDArray>;
using Dimensions = std::vector<std::shared_ptr<GDALDimension>>;

constexpr double NoValue = std::numeric_limits<double>::quiet_NaN();
constexpr GUInt64 MostValues = 2000000000;
constexpr GUInt64 MostNodes = 10000; // frequencies, directions

std::string unitOf(const GDALMDArray& array)
{
  return plain(array.GetUnit().empty() ? attribute(array, "units") : array.GetUnit());
}

std::vector<double> valuesOf(const GDALMDArray& array)
{
  if (!isNumeric(array) || array.GetTotalElementsCount() > MostValues)
  {
    throw std::runtime_error("its variable '" + array.GetName() + "' holds no numbers, or too many");
  }
  std::vector<double> values(static_cast<std::size_t>(array.GetTotalElementsCount()));
  std::vector<GUInt64> start(array.GetDimensionCount(), 0);
  std::vector<std::size_t> count;
  for (const auto& dimension : array.GetDimensions())
  {
    count.push_back(static_cast<std::size_t>(dimension->GetSize()));
  }
  if (!values.empty())
  {
    require(array.Read(
      start.data(), count.data(), nullptr, nullptr, GDALExtendedDataType::Create(GDT_Float64), values.data()));
  }
  maskAndScale(array, NoValue, values);
  return values;
}

enum class Role
{
  Time,
  Station,
  Frequency,
  Direction
};

Role roleOf(const GDALDimension& dimension, const Array& coordinate)
{
  const std::string name = plain(dimension.GetName());
  const std::string standard = coordinate ? plain(attribute(*coordinate, "standard_name")) : "";
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  if (has(standard, "frequency") || has(name, "freq"))
  {
    return Role::Frequency;
  }
  if (has(standard, "direction") || name.compare(0, 3, "dir") == 0)
  {
    return Role::Direction;
  }
  return standard == "time" || name == "time" ? Role::Time : Role::Station;
}

class Reader
{
public:
  explicit Reader(GDALGroup& root)
    : Root(root)
  {
  }

  SpectrumFile read();

private:
  Array open(const std::string& name) const { return this->Root.OpenMDArray(name); }
  Array density() const;
  void readFrequencies(const Array& coordinate, std::size_t size);
  void readDirections(const Array& coordinate, std::size_t size);
  std::vector<std::string> readTimes(std::size_t size) const;
  std::optional<glm::dvec2> placeAt(std::size_t time, std::size_t station, std::size_t stations);

  GDALGroup& Root;
  SpectrumFile File;
  SpectralGrid Grid;
  std::vector<std::size_t> Order; // of increasing headings
  std::vector<double> Places[2];
  bool PlacesRead = false;
  bool Geographic = true;
};

Array Reader::density() const
{
  for (const NetcdfArray& array : listArrays(this->Root))
  {
    const std::string standard = plain(attribute(*array.array, "standard_name"));
    const std::string name = plain(array.array->GetName());
    if (array.array->GetDimensionCount() >= 2 &&
      (name == "efth" || standard == "sea_surface_wave_directional_variance_spectral_density"))
    {
      return array.array;
    }
  }
  throw std::runtime_error("it has no directional spectrum: no variable efth, nor one with the standard name "
                           "sea_surface_wave_directional_variance_spectral_density");
}

void Reader::readFrequencies(const Array& coordinate, std::size_t size)
{
  if (!coordinate || coordinate->GetTotalElementsCount() != size)
  {
    throw std::runtime_error("its frequencies have no variable of their own");
  }
  this->Grid.frequencies = valuesOf(*coordinate);
  const std::string unit = unitOf(*coordinate);
  if (!(unit.empty() || unit == "hz" || unit == "s-1" || unit == "1/s" || unit == "hertz"))
  {
    throw std::runtime_error("its frequencies are in '" + oneLine(unit) + "'; Hz are needed");
  }
}

void Reader::readDirections(const Array& coordinate, std::size_t size)
{
  if (!coordinate || coordinate->GetTotalElementsCount() != size)
  {
    throw std::runtime_error("its directions have no variable of their own");
  }
  const std::string standard = plain(attribute(*coordinate, "standard_name"));
  const std::string longName = plain(attribute(*coordinate, "long_name"));
  const auto says = [&](const char* word) { return (standard + " " + longName).find(word) != std::string::npos; };
  bool from = standard.find("from_direction") != std::string::npos;
  if (!from && standard.find("to_direction") == std::string::npos)
  {
    from = says("from") && !says(" to ");
    this->File.notes.emplace_back(from ? "directions are taken as those the waves come from"
                                       : "directions are taken as those the waves go to, as WAVEWATCH III has them");
  }
  const double unit = unitOf(*coordinate).compare(0, 3, "rad") == 0 ? degrees(1.0) : 1.0;
  std::vector<double> headings;
  for (const double direction : valuesOf(*coordinate))
  {
    const double heading = from ? headingFromNautical(direction * unit) : radians(90.0 - direction * unit);
    headings.push_back(heading - 2.0 * Pi * std::floor(heading / (2.0 * Pi)));
  }
  this->Order.resize(size);
  std::iota(this->Order.begin(), this->Order.end(), std::size_t(0));
  std::sort(
    this->Order.begin(), this->Order.end(), [&](std::size_t a, std::size_t b) { return headings[a] < headings[b]; });
  for (const std::size_t j : this->Order)
  {
    this->Grid.headings.push_back(headings[j]);
  }
}

std::vector<std::string> Reader::readTimes(std::size_t size) const
{
  std::vector<std::string> times(size);
  const Array array = this->open("time");
  if (array && isNumeric(*array) && array->GetTotalElementsCount() == size)
  {
    const std::string units = array->GetUnit().empty() ? attribute(*array, "units") : array->GetUnit();
    const std::vector<double> values = valuesOf(*array);
    for (std::size_t i = 0; i < size; ++i)
    {
      const std::optional<double> seconds = secondsOfUnits(values[i], units);
      times[i] = seconds ? timeOfSeconds(*seconds) : text(values[i], 12);
    }
  }
  return times;
}

std::optional<glm::dvec2> Reader::placeAt(std::size_t time, std::size_t station, std::size_t stations)
{
  if (!this->PlacesRead)
  {
    this->PlacesRead = true;
    const char* const names[2][2] = { { "longitude", "latitude" }, { "x", "y" } };
    for (int pair = 0; pair < 2 && this->Places[0].empty(); ++pair)
    {
      const Array x = this->open(names[pair][0]);
      const Array y = this->open(names[pair][1]);
      if (x && y && isNumeric(*x) && isNumeric(*y))
      {
        this->Places[0] = valuesOf(*x);
        this->Places[1] = valuesOf(*y);
        this->Geographic = pair == 0;
      }
    }
  }
  // One a station, or one a time and station.
  const std::size_t count = this->Places[0].size();
  const std::size_t i = count == stations ? station : time * stations + station;
  if (count != this->Places[1].size() || i >= count || !std::isfinite(this->Places[0][i] + this->Places[1][i]))
  {
    return {};
  }
  return glm::dvec2(this->Places[0][i], this->Places[1][i]);
}

SpectrumFile Reader::read()
{
  this->File.format = "NetCDF";
  const Array array = this->density();
  const auto& dimensions = array->GetDimensions();
  std::size_t sizes[4] = { 1, 1, 1, 1 };
  std::size_t strides[4] = { 0, 0, 0, 0 };
  bool seen[4] = { false, false, false, false };
  std::size_t stride = 1;
  for (std::size_t d = dimensions.size(); d-- > 0;)
  {
    const Array coordinate = this->open(dimensions[d]->GetName());
    const auto role = static_cast<std::size_t>(roleOf(*dimensions[d], coordinate));
    const auto size = static_cast<std::size_t>(dimensions[d]->GetSize());
    if (seen[role])
    {
      throw std::runtime_error("the dimensions of '" + array->GetName() +
        "' are not time, station, frequency and "
        "direction");
    }
    seen[role] = true;
    sizes[role] = size;
    strides[role] = stride;
    stride *= size;
    if (role >= static_cast<std::size_t>(Role::Frequency) && size > MostNodes)
    {
      throw std::runtime_error("it has more than 10000 frequencies or directions");
    }
    if (role == static_cast<std::size_t>(Role::Frequency))
    {
      this->readFrequencies(coordinate, size);
    }
    if (role == static_cast<std::size_t>(Role::Direction))
    {
      this->readDirections(coordinate, size);
    }
  }
  if (this->Grid.frequencies.empty() || this->Grid.headings.empty())
  {
    throw std::runtime_error("'" + array->GetName() + "' has no dimension of frequency, or none of direction");
  }
  this->Grid.validate();
  const std::string unit = unitOf(*array);
  const double factor = unit.find("deg") != std::string::npos ? degrees(1.0) : 1.0;
  if (unit.find("deg") == std::string::npos && unit.find("rad") == std::string::npos)
  {
    this->File.notes.emplace_back("densities are taken as m2/(Hz rad)");
  }
  const std::vector<double> values = valuesOf(*array);
  const std::vector<std::string> times = this->readTimes(sizes[0]);
  const std::size_t directions = sizes[3];
  std::size_t missing = 0;
  for (std::size_t t = 0; t < sizes[0]; ++t)
  {
    for (std::size_t s = 0; s < sizes[1]; ++s)
    {
      SpectrumRecord record;
      record.time = times[t];
      record.place = this->placeAt(t, s, sizes[1]);
      record.geographic = this->Geographic;
      record.spectrum.grid = this->Grid;
      record.spectrum.density.resize(this->Grid.size());
      bool whole = true;
      for (std::size_t i = 0; i < sizes[2]; ++i)
      {
        for (std::size_t j = 0; j < directions; ++j)
        {
          const double value =
            values[t * strides[0] + s * strides[1] + i * strides[2] + this->Order[j] * strides[3]] * factor;
          record.spectrum.density[i * directions + j] = value;
          whole = whole && value >= 0.0 && std::isfinite(value);
        }
      }
      missing += whole ? 0 : 1;
      if (whole)
      {
        this->File.records.push_back(std::move(record));
      }
    }
  }
  if (this->File.records.empty())
  {
    throw std::runtime_error("it holds no whole spectrum");
  }
  if (missing > 0)
  {
    this->File.notes.push_back(std::to_string(missing) + " spectra are not whole and are left out");
  }
  return std::move(this->File);
}

struct Column
{
  const char* name;
  const char* longName;
  const char* unit;
  const char* standardName;
};

void addColumn(GDALGroup& root, const Dimensions& dimensions, const Column& column, const std::vector<double>& values)
{
  const auto type = GDALExtendedDataType::Create(GDT_Float64);
  const auto array = root.CreateMDArray(column.name, dimensions, type);
  require(array != nullptr);
  setText(*array, "long_name", column.longName);
  setText(*array, "units", column.unit);
  if (*column.standardName)
  {
    setText(*array, "standard_name", column.standardName);
  }
  std::vector<GUInt64> start(dimensions.size(), 0);
  std::vector<std::size_t> count;
  for (const auto& dimension : dimensions)
  {
    count.push_back(static_cast<std::size_t>(dimension->GetSize()));
  }
  require(array->Write(start.data(), count.data(), nullptr, nullptr, type, values.data()));
}

}

SpectrumFile readNetcdfSpectra(const std::string& path)
{
  const QuietGdal quiet;
  try
  {
    const Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_MULTIDIM_RASTER));
    const std::shared_ptr<GDALGroup> root = dataset ? dataset->GetRootGroup() : nullptr;
    if (!root)
    {
      throw std::runtime_error(QuietGdal::lastError("it is no NetCDF file"));
    }
    return Reader(*root).read();
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error("cannot read the spectra of '" + path + "': " + error.what());
  }
}

void writeNetcdfSpectra(const std::string& path, const std::vector<SpectrumRecord>& records, const std::string& source)
{
  if (records.empty())
  {
    throw std::invalid_argument("there is no spectrum to write");
  }
  // Times and places come in the order of the file: place by place within time by time.
  const SpectralGrid& grid = records.front().spectrum.grid;
  std::size_t stations = 0;
  while (stations < records.size() && records[stations].time == records.front().time)
  {
    ++stations;
  }
  const std::size_t times = records.size() / stations;
  const bool timed = !records.front().time.empty();
  std::vector<double> seconds;
  for (std::size_t r = 0; r < records.size(); ++r)
  {
    const SpectrumRecord& record = records[r];
    if (record.spectrum.grid.frequencies != grid.frequencies || record.spectrum.grid.headings != grid.headings ||
      times * stations != records.size() || record.time != records[r / stations * stations].time ||
      record.place != records[r % stations].place)
    {
      throw std::invalid_argument(
        "the spectra of a file must all have the same frequencies and directions, and each time the same places");
    }
    if (r % stations == 0)
    {
      const std::optional<double> when = timed ? secondsOfTime(record.time) : std::optional<double>(0.0);
      if (!when)
      {
        throw std::invalid_argument("'" + oneLine(record.time) + "' is no time that NetCDF could hold");
      }
      seconds.push_back(*when);
    }
  }
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> numbers;
  for (std::size_t s = 0; s < stations; ++s)
  {
    const glm::dvec2 place = records[s].place.value_or(glm::dvec2(NoValue));
    x.push_back(place.x);
    y.push_back(place.y);
    numbers.push_back(static_cast<double>(s + 1));
  }
  const auto to = [&](std::size_t j) { return wrapDegrees(90.0 - degrees(grid.headings[j])); };
  std::vector<std::size_t> order(grid.headings.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return to(a) < to(b); });
  std::vector<double> directions;
  for (const std::size_t j : order)
  {
    directions.push_back(to(j));
  }
  std::vector<double> density;
  density.reserve(records.size() * grid.size());
  for (const SpectrumRecord& record : records)
  {
    for (std::size_t i = 0; i < grid.frequencies.size(); ++i)
    {
      for (const std::size_t j : order)
      {
        density.push_back(record.spectrum.at(i, j));
      }
    }
  }

  const QuietGdal quiet;
  const NoSideCars noSideCars;
  requireRoom(path, density.size() * sizeof(double));
  Dataset dataset = createNetcdf(path);
  {
    const std::shared_ptr<GDALGroup> root = dataset->GetRootGroup();
    require(root != nullptr);
    setText(*root, "Conventions", "CF-1.8");
    setText(*root, "title", "Directional wave spectra");
    setText(*root, "source", source);
    const auto dimension = [&](const char* name, std::size_t size)
    {
      auto made = root->CreateDimension(name, "", "", size);
      require(made != nullptr);
      return made;
    };
    const auto time = dimension("time", times);
    const auto station = dimension("station", stations);
    const auto frequency = dimension("frequency", grid.frequencies.size());
    const auto direction = dimension("direction", directions.size());
    if (timed)
    {
      addColumn(*root, { time }, { "time", "time", "seconds since 1970-01-01 00:00:00", "time" }, seconds);
    }
    addColumn(*root, { station }, { "station", "number of the station", "1", "" }, numbers);
    addColumn(*root, { frequency }, { "frequency", "frequency", "s-1", "wave_frequency" }, grid.frequencies);
    addColumn(*root, { direction },
      { "direction", "direction the waves go to, clockwise from north", "degree", "sea_surface_wave_to_direction" },
      directions);
    if (records.front().geographic)
    {
      addColumn(*root, { station }, { "longitude", "longitude", "degrees_east", "longitude" }, x);
      addColumn(*root, { station }, { "latitude", "latitude", "degrees_north", "latitude" }, y);
    }
    else
    {
      addColumn(*root, { station }, { "x", "east in the coordinates of the seafloor", "m", "" }, x);
      addColumn(*root, { station }, { "y", "north in the coordinates of the seafloor", "m", "" }, y);
    }
    addColumn(*root, { time, station, frequency, direction },
      { "efth", "variance density over frequency and direction", "m2 s rad-1",
        "sea_surface_wave_directional_variance_spectral_density" },
      density);
  }
  close(dataset);
}

}
