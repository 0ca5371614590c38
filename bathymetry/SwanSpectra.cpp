#include "bathymetry/SpectrumFormats.h"

#include "bathymetry/Text.h"
#include "sim/Angles.h"
#include "sim/Dispersion.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <memory>
#include <numeric>
#include <stdexcept>

namespace swellray
{

namespace
{

// More than any spectrum has, and less than would fill the memory.
constexpr std::size_t MostNumbers = 10000;

// Density of sea water in SWAN, kg/m3, which its energy densities contain.
constexpr double SwanWaterDensity = 1025.0;

constexpr double NoValue = std::numeric_limits<double>::quiet_NaN();

/** Lines and numbers of a file, with a place for messages. */
class Lines
{
public:
  explicit Lines(const std::string& path)
    : Path(path)
    , File(path)
  {
    if (!this->File)
    {
      throw std::runtime_error("cannot read '" + path + "': no such file, or it may not be read");
    }
  }

  [[noreturn]] void fail(const std::string& what) const
  {
    throw std::runtime_error("'" + this->Path + "' line " + std::to_string(this->Number) + ": " + what);
  }

  /** The next line that is not a comment; false at the end. */
  bool next()
  {
    std::string line;
    while (std::getline(this->File, line))
    {
      ++this->Number;
      constexpr std::size_t Longest = 1000000;
      if (line.size() > Longest)
      {
        this->fail("a line of more than a million characters: not a spectral file");
      }
      if (!line.empty() && line[0] == '$')
      {
        continue;
      }
      this->Words.clear();
      std::size_t from = 0;
      while ((from = line.find_first_not_of(" \t\r", from)) != std::string::npos)
      {
        const std::size_t to = std::min(line.find_first_of(" \t\r", from), line.size());
        this->Words.push_back(line.substr(from, to - from));
        from = to;
      }
      if (!this->Words.empty())
      {
        this->At = 0;
        return true;
      }
    }
    this->Words.clear();
    this->At = 0;
    return false;
  }

  void need(const char* what)
  {
    if (!this->next())
    {
      throw std::runtime_error("'" + this->Path + "' ends where " + what + " should come");
    }
  }

  /** First word of the line, in lower case. */
  std::string key() const { return this->Words.empty() ? "" : plain(this->Words[0]); }
  const std::vector<std::string>& words() const { return this->Words; }
  std::size_t number() const { return this->Number; }

  double numberOf(std::size_t word, const char* what) const
  {
    double value = 0.0;
    if (word < this->Words.size())
    {
      std::string text = this->Words[word];
      std::replace(text.begin(), text.end(), 'D', 'E'); // Fortran's double precision
      const char* begin = text.data() + (text[0] == '+' ? 1 : 0);
      const auto [stop, error] = std::from_chars(begin, text.data() + text.size(), value);
      if (error == std::errc() && stop == text.data() + text.size() && std::isfinite(value))
      {
        return value;
      }
    }
    this->fail(std::string("no number where ") + what + " should be");
  }

  std::size_t count(const char* what) const
  {
    const double value = this->numberOf(0, what);
    if (!(value >= 0.0 && value <= static_cast<double>(MostNumbers) && value == std::floor(value)))
    {
      this->fail(std::string(what) + " must be a whole number up to 10000, not " + text(value));
    }
    return static_cast<std::size_t>(value);
  }

  /** The next number of the running text, over the ends of lines. */
  double running(const char* what)
  {
    while (this->At >= this->Words.size())
    {
      this->need(what);
    }
    return this->numberOf(this->At++, what);
  }

private:
  std::string Path;
  std::ifstream File;
  std::size_t Number = 0;
  std::vector<std::string> Words;
  std::size_t At = 0;
};

enum class Content
{
  Variance,
  Direction,
  Spread,
  Other
};

struct Quantity
{
  Content content = Content::Other;
  double factor = 1.0; // to m2/Hz, or m2/(Hz rad)
  bool nautical = true;
  double exception = NoValue;
};

class SwanReader
{
public:
  explicit SwanReader(const std::string& path)
    : In(path)
  {
  }

  SpectrumFile read();

private:
  void readHeader();
  void readQuantities(bool nautical);
  void readPlaces(bool geographic);
  void readRecord(std::size_t place);
  void readLines();
  void readMatrix();
  SpectrumRecord& add(std::size_t place);

  Lines In;
  SpectrumFile Result;
  std::string Time;
  bool HasTime = false;
  bool Geographic = false;
  std::vector<glm::dvec2> Places;
  std::vector<double> Frequencies;
  std::vector<double> Headings;   // rad, as they come in the file
  std::vector<std::size_t> Order; // of increasing headings
  std::vector<Quantity> Quantities;
};

void SwanReader::readPlaces(bool geographic)
{
  this->Geographic = geographic;
  this->In.need("the number of locations");
  const std::size_t count = this->In.count("the number of locations");
  for (std::size_t i = 0; i < count; ++i)
  {
    this->In.need("a location");
    this->Places.emplace_back(this->In.numberOf(0, "x of a location"), this->In.numberOf(1, "y of a location"));
  }
}

void SwanReader::readQuantities(bool nautical)
{
  this->In.need("the number of quantities");
  const std::size_t count = this->In.count("the number of quantities");
  for (std::size_t i = 0; i < count; ++i)
  {
    Quantity quantity;
    this->In.need("a quantity");
    const std::string name = this->In.key();
    this->In.need("the unit of a quantity");
    const std::string unit = this->In.key();
    this->In.need("the exception value of a quantity");
    quantity.exception = this->In.numberOf(0, "an exception value");
    if (name == "vadens" || name == "endens")
    {
      quantity.content = Content::Variance;
      quantity.factor = unit.find("degr") != std::string::npos ? degrees(1.0) : 1.0;
      if (name == "endens")
      {
        quantity.factor /= SwanWaterDensity * StandardGravity;
      }
    }
    else if (name == "cdir" || name == "ndir" || name == "dir")
    {
      quantity.content = Content::Direction;
      quantity.nautical = name == "dir" ? nautical : name == "ndir";
    }
    else if (name == "dspr" || name == "dsprdegr")
    {
      quantity.content = Content::Spread;
    }
    this->Quantities.push_back(quantity);
  }
}

void SwanReader::readHeader()
{
  this->In.need("the heading SWAN");
  if (this->In.key() != "swan")
  {
    this->In.fail("the file does not begin with SWAN: no SWAN spectral file");
  }
  bool nautical = true;
  while (this->Quantities.empty())
  {
    this->In.need("QUANT");
    const std::string key = this->In.key();
    if (key == "time")
    {
      this->HasTime = true;
      this->In.need("the time coding");
    }
    else if (key == "lonlat" || key == "locations")
    {
      this->readPlaces(key == "lonlat");
    }
    else if (key == "afreq" || key == "rfreq")
    {
      if (key == "rfreq")
      {
        this->Result.notes.emplace_back("relative frequencies are taken as absolute ones");
      }
      this->In.need("the number of frequencies");
      const std::size_t count = this->In.count("the number of frequencies");
      for (std::size_t i = 0; i < count; ++i)
      {
        this->In.need("a frequency");
        this->Frequencies.push_back(this->In.numberOf(0, "a frequency"));
      }
    }
    else if (key == "ndir" || key == "cdir")
    {
      nautical = key == "ndir";
      this->In.need("the number of directions");
      const std::size_t count = this->In.count("the number of directions");
      for (std::size_t i = 0; i < count; ++i)
      {
        this->In.need("a direction");
        const double direction = this->In.numberOf(0, "a direction");
        const double heading = nautical ? headingFromNautical(direction) : radians(direction);
        this->Headings.push_back(heading - 2.0 * Pi * std::floor(heading / (2.0 * Pi)));
      }
    }
    else if (key == "quant")
    {
      this->readQuantities(nautical);
    }
    else
    {
      this->In.fail("unknown heading '" + oneLine(this->In.words()[0]) + "' in a SWAN spectral file");
    }
  }
  this->Order.resize(this->Headings.size());
  std::iota(this->Order.begin(), this->Order.end(), 0);
  std::sort(this->Order.begin(), this->Order.end(),
    [&](std::size_t a, std::size_t b) { return this->Headings[a] < this->Headings[b]; });
  if (this->Frequencies.size() < 2)
  {
    this->In.fail("the file gives no frequencies (AFREQ or RFREQ, at least 2)");
  }
  const bool spectral = std::any_of(
    this->Quantities.begin(), this->Quantities.end(), [](const Quantity& q) { return q.content == Content::Variance; });
  if (!spectral)
  {
    this->In.fail("the file has no variance or energy densities (VaDens or EnDens)");
  }
}

SpectrumRecord& SwanReader::add(std::size_t place)
{
  SpectrumRecord record;
  record.time = this->Time;
  record.geographic = this->Geographic;
  if (place < this->Places.size())
  {
    record.place = this->Places[place];
  }
  record.spectrum.grid.frequencies = this->Frequencies;
  if (this->Headings.empty())
  {
    for (std::size_t j = 0; j < StandardDirections; ++j)
    {
      record.spectrum.grid.headings.push_back(2.0 * Pi * static_cast<double>(j) / StandardDirections);
    }
  }
  else
  {
    for (const std::size_t j : this->Order)
    {
      record.spectrum.grid.headings.push_back(this->Headings[j]);
    }
  }
  try
  {
    record.spectrum.grid.validate();
  }
  catch (const std::invalid_argument& error)
  {
    this->In.fail(error.what());
  }
  record.spectrum.density.assign(record.spectrum.grid.size(), 0.0);
  this->Result.records.push_back(std::move(record));
  return this->Result.records.back();
}

void SwanReader::readLines()
{
  DirectionalSpectrum& spectrum = this->Result.records.back().spectrum;
  const std::vector<double> widths = spectrum.grid.headingWeights();
  for (std::size_t i = 0; i < this->Frequencies.size(); ++i)
  {
    this->In.need("a density");
    double density = 0.0;
    double heading = NoValue;
    double spread = NoValue;
    for (std::size_t q = 0; q < this->Quantities.size(); ++q)
    {
      const Quantity& quantity = this->Quantities[q];
      const double value = this->In.numberOf(q, "a density, direction or spread");
      if (value == quantity.exception)
      {
        continue;
      }
      switch (quantity.content)
      {
      case Content::Variance:
        density = value * quantity.factor;
        break;
      case Content::Direction:
        heading = quantity.nautical ? headingFromNautical(value) : radians(value);
        break;
      case Content::Spread:
        spread = value;
        break;
      case Content::Other:
        break;
      }
    }
    if (density < 0.0)
    {
      this->In.fail("a density below 0");
    }
    if (density > 0.0)
    {
      if (std::isnan(heading) || std::isnan(spread))
      {
        this->In.fail("a density without direction and spread (CDIR or NDIR, and DSPR)");
      }
      const auto spreading = DirectionalSpreading::cosinePower(radians(std::clamp(spread, 1.0, 80.0)));
      for (std::size_t j = 0; j < widths.size(); ++j)
      {
        const double angle = spectrum.grid.headings[j] - heading;
        spectrum.density[i * widths.size() + j] =
          density * spreading.share(1.0, angle - 0.5 * widths[j], angle + 0.5 * widths[j]) / widths[j];
      }
    }
  }
}

void SwanReader::readMatrix()
{
  DirectionalSpectrum& spectrum = this->Result.records.back().spectrum;
  this->In.need("the factor of a spectrum");
  const double factor = this->In.numberOf(0, "the factor of a spectrum");
  const Quantity& quantity = this->Quantities.front();
  const std::size_t directions = this->Headings.size();
  std::vector<double> row(directions);
  for (std::size_t i = 0; i < this->Frequencies.size(); ++i)
  {
    // A row may run over several lines, but begins on its own.
    this->In.need("a row of densities");
    for (double& value : row)
    {
      value = this->In.running("a density");
      value = value == quantity.exception ? 0.0 : value * factor * quantity.factor;
      if (value < 0.0)
      {
        this->In.fail("a density below 0");
      }
    }
    for (std::size_t j = 0; j < directions; ++j)
    {
      spectrum.density[i * directions + j] = row[this->Order[j]];
    }
  }
}

void SwanReader::readRecord(std::size_t place)
{
  const std::string key = this->In.key();
  if (key == "nodata")
  {
    return;
  }
  this->add(place);
  if (key == "zero")
  {
    return;
  }
  if (key == "factor")
  {
    if (this->Headings.empty())
    {
      this->In.fail("FACTOR in a file without directions");
    }
    this->readMatrix();
  }
  else if (key == "location")
  {
    if (!this->Headings.empty())
    {
      this->In.fail("LOCATION in a file with directions: FACTOR is expected");
    }
    this->readLines();
  }
  else
  {
    this->In.fail("'" + oneLine(this->In.words()[0]) + "' where LOCATION, FACTOR, ZERO or NODATA should be");
  }
}

SpectrumFile SwanReader::read()
{
  this->Result.format = "SWAN";
  this->readHeader();
  const std::size_t places = std::max<std::size_t>(this->Places.size(), 1);
  std::size_t place = 0;
  while (this->In.next())
  {
    const std::string key = this->In.key();
    const bool isRecord = key == "location" || key == "factor" || key == "zero" || key == "nodata";
    if (!isRecord && place == 0 && this->HasTime)
    {
      this->Time = this->In.words()[0];
      continue;
    }
    this->readRecord(place);
    place = (place + 1) % places;
  }
  if (this->Result.records.empty())
  {
    this->In.fail("the file holds no spectrum");
  }
  return std::move(this->Result);
}

}

SpectrumFile readSwanSpectra(const std::string& path)
{
  return SwanReader(path).read();
}

void writeSwanSpectra(const std::string& path, const std::vector<SpectrumRecord>& records, const std::string& source)
{
  if (records.empty())
  {
    throw std::invalid_argument("there is no spectrum to write");
  }
  const SpectralGrid& grid = records.front().spectrum.grid;
  for (const SpectrumRecord& record : records)
  {
    if (record.spectrum.grid.frequencies != grid.frequencies || record.spectrum.grid.headings != grid.headings)
    {
      throw std::invalid_argument("the spectra of a file must all have the same frequencies and directions");
    }
  }
  std::vector<std::size_t> order(grid.headings.size());
  std::iota(order.begin(), order.end(), 0);
  const auto nautical = [&](std::size_t j) { return wrapDegrees(270.0 - degrees(grid.headings[j])); };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return nautical(a) < nautical(b); });

  // Places come once, in the order of the first time.
  std::vector<const SpectrumRecord*> places;
  bool timed = !records.front().time.empty();
  for (const SpectrumRecord& record : records)
  {
    if (record.time == records.front().time)
    {
      places.push_back(&record);
    }
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "w"), &std::fclose);
  if (!file)
  {
    throw std::runtime_error("cannot write '" + path + "'");
  }
  std::FILE* out = file.get();
  std::fprintf(out, "SWAN   1                                Swan standard spectral file, version\n");
  std::fprintf(out, "$   Data produced by %s\n", oneLine(source).c_str());
  if (timed)
  {
    std::fprintf(out,
      "TIME                                    time-dependent data\n     1                                  time "
      "coding option\n");
  }
  std::fprintf(out,
    records.front().geographic ? "LONLAT                                  locations in spherical "
                                 "coordinates\n"
                               : "LOCATIONS                               locations in x-y-space\n");
  std::fprintf(out, "%6zu                                  number of locations\n", places.size());
  for (const SpectrumRecord* record : places)
  {
    const glm::dvec2 place = record->place.value_or(glm::dvec2(0.0));
    std::fprintf(out, "%18.6f %18.6f\n", place.x, place.y);
  }
  std::fprintf(out, "AFREQ                                   absolute frequencies in Hz\n");
  std::fprintf(out, "%6zu                                  number of frequencies\n", grid.frequencies.size());
  for (const double f : grid.frequencies)
  {
    std::fprintf(out, "%12.6f\n", f);
  }
  std::fprintf(out, "NDIR                                    spectral nautical directions in degr\n");
  std::fprintf(out, "%6zu                                  number of directions\n", grid.headings.size());
  for (const std::size_t j : order)
  {
    std::fprintf(out, "%12.4f\n", nautical(j));
  }
  std::fprintf(out,
    "QUANT\n     1                                  number of quantities in table\n"
    "VaDens                                  variance densities in m2/Hz/degr\n"
    "m2/Hz/degr                              unit\n"
    "   -0.9900E+02                          exception value\n");
  std::string time;
  for (const SpectrumRecord& record : records)
  {
    if (timed && record.time != time)
    {
      time = record.time;
      std::fprintf(out, "%-40sdate and time\n", time.c_str());
    }
    const auto& density = record.spectrum.density;
    const double largest = radians(1.0) * (density.empty() ? 0.0 : *std::max_element(density.begin(), density.end()));
    if (!(largest > 0.0))
    {
      std::fprintf(out, "ZERO\n");
      continue;
    }
    const double factor = largest / 99999.0;
    std::fprintf(out, "FACTOR\n%18.8E\n", factor);
    for (std::size_t i = 0; i < grid.frequencies.size(); ++i)
    {
      for (const std::size_t j : order)
      {
        std::fprintf(out, " %5.0f", radians(1.0) * record.spectrum.at(i, j) / factor);
      }
      std::fputc('\n', out);
    }
  }
  if (std::fflush(out) != 0 || std::ferror(out))
  {
    throw std::runtime_error("cannot write '" + path + "': the disk is full, or files may not get so large");
  }
}

}
