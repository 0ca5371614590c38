#include "bathymetry/CalendarTime.h"
#include "bathymetry/SpectrumFormats.h"
#include "bathymetry/Text.h"
#include "sim/Angles.h"
#include "sim/MaximumEntropySpreading.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>

namespace swellray
{

namespace
{

namespace fs = std::filesystem;

constexpr double NoValue = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t MostFrequencies = 1000;
constexpr std::size_t MostTimes = 1000000;

/** One quantity of a buoy: a value a frequency, at each of its times. */
struct Quantity
{
  std::vector<double> frequencies;
  std::map<std::string, std::vector<double>> values; // by time; NaN: missing
};

std::vector<std::string> wordsOf(const std::string& line)
{
  std::vector<std::string> words;
  std::size_t from = 0;
  while ((from = line.find_first_not_of(" \t\r", from)) != std::string::npos)
  {
    const std::size_t to = std::min(line.find_first_of(" \t\r", from), line.size());
    words.push_back(line.substr(from, to - from));
    from = to;
  }
  return words;
}

std::optional<double> numberOf(const std::string& word)
{
  double value = 0.0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  return error == std::errc() && stop == end && std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

class Reader
{
public:
  explicit Reader(const std::string& path)
    : Path(path)
    , File(path)
  {
  }

  Quantity read();

private:
  [[noreturn]] void fail(const std::string& what) const
  {
    throw std::runtime_error("'" + this->Path + "' line " + std::to_string(this->Number) + ": " + what);
  }

  void readHeading(const std::vector<std::string>& words);
  void readLine(const std::vector<std::string>& words);
  double parse(const std::string& word, const char* what) const
  {
    const std::optional<double> value = numberOf(word);
    if (!value)
    {
      this->fail("'" + oneLine(word).substr(0, 40) + "' is no " + what);
    }
    return *value;
  }

  std::string Path;
  std::ifstream File;
  std::size_t Number = 0;
  std::size_t TimeColumns = 0;
  bool Pairs = false; // value (frequency), as of the last 45 days
  Quantity Result;
};

void Reader::readHeading(const std::vector<std::string>& words)
{
  // Year, month, day, hour, and the minute where there is one; then frequencies, or words about pairs.
  std::size_t column = 0;
  while (column < words.size() && column < 5)
  {
    const std::string word = plain(words[column][0] == '#' ? words[column].substr(1) : words[column]);
    if (word != "yy" && word != "yyyy" && word != "yr" && word != "mm" && word != "mo" && word != "dd" &&
      word != "dy" && word != "hh" && word != "hr" && word != "mn")
    {
      break;
    }
    ++column;
  }
  if (column < 4)
  {
    this->fail("the heading does not begin with year, month, day and hour: no spectral file of NDBC");
  }
  this->TimeColumns = column;
  this->Pairs = column == words.size() || !numberOf(words[column]);
  for (; column < words.size() && !this->Pairs; ++column)
  {
    this->Result.frequencies.push_back(this->parse(words[column], "frequency"));
  }
}

void Reader::readLine(const std::vector<std::string>& words)
{
  if (words.size() <= this->TimeColumns)
  {
    this->fail("the line has no values");
  }
  int when[5] = { 0, 0, 0, 0, 0 };
  for (std::size_t i = 0; i < this->TimeColumns; ++i)
  {
    const double value = this->parse(words[i], "part of a time");
    if (!(value >= 0.0 && value <= 9999.0))
    {
      this->fail("'" + words[i] + "' is no part of a time");
    }
    when[i] = static_cast<int>(value);
  }
  when[0] += when[0] < 100 ? 1900 : 0; // files before 1999
  char time[64];
  std::snprintf(time, sizeof time, "%04d-%02d-%02dT%02d:%02d", when[0], when[1], when[2], when[3], when[4]);
  if (!secondsOfTime(time))
  {
    this->fail(std::string(time) + " is no time");
  }
  std::vector<double> values;
  const auto valueOf = [&](const std::string& word)
  {
    const double value = word == "MM" ? NoValue : this->parse(word, "value");
    return value >= 999.0 ? NoValue : value;
  };
  if (!this->Pairs)
  {
    for (std::size_t i = this->TimeColumns; i < words.size(); ++i)
    {
      values.push_back(valueOf(words[i]));
    }
  }
  else
  {
    // The frequency of separation of sea and swell stands alone before the pairs.
    std::vector<double> frequencies;
    for (std::size_t i = this->TimeColumns; i + 1 < words.size(); ++i)
    {
      const std::string& next = words[i + 1];
      if (next.size() > 2 && next.front() == '(' && next.back() == ')')
      {
        values.push_back(valueOf(words[i]));
        frequencies.push_back(this->parse(next.substr(1, next.size() - 2), "frequency"));
        ++i;
      }
    }
    if (this->Result.frequencies.empty())
    {
      this->Result.frequencies = frequencies;
    }
    if (frequencies != this->Result.frequencies)
    {
      return; // another instrument: its frequencies are not those of the file
    }
  }
  if (values.size() != this->Result.frequencies.size())
  {
    this->fail("the line has " + std::to_string(values.size()) + " values for " +
      std::to_string(this->Result.frequencies.size()) + " frequencies");
  }
  if (this->Result.values.size() >= MostTimes)
  {
    this->fail("more than a million times");
  }
  this->Result.values[time] = std::move(values);
}

Quantity Reader::read()
{
  if (!this->File)
  {
    throw std::runtime_error("cannot read '" + this->Path + "': no such file, or it may not be read");
  }
  std::string line;
  while (std::getline(this->File, line))
  {
    ++this->Number;
    const std::vector<std::string> words = wordsOf(line);
    if (words.empty())
    {
      continue;
    }
    if (this->TimeColumns == 0)
    {
      this->readHeading(words);
    }
    else if (words[0][0] != '#')
    {
      this->readLine(words);
    }
    if (this->Result.frequencies.size() > MostFrequencies)
    {
      this->fail("more than a thousand frequencies");
    }
  }
  if (this->Result.values.empty())
  {
    throw std::runtime_error("'" + this->Path + "' holds no values");
  }
  return std::move(this->Result);
}

/** Names of the files beside one of densities. */
struct Family
{
  std::string direction1;
  std::string direction2;
  std::string length1;
  std::string length2;
  double lengthFactor = 1.0;
};

Family familyOf(const std::string& path)
{
  const fs::path file(path);
  const std::string name = file.filename().string();
  const auto beside = [&](const std::string& other) { return (file.parent_path() / other).string(); };
  const std::string ending = file.extension().string();
  if (ending == ".data_spec" || ending == ".spec" || ending == ".swden")
  {
    const std::string stem = file.stem().string();
    return { beside(stem + ".swdir"), beside(stem + ".swdir2"), beside(stem + ".swr1"), beside(stem + ".swr2"), 1.0 };
  }
  // 46042w2010.txt and its like, or a month 46042w12010.txt: the w before the digits tells the quantity.
  const std::size_t end = name.find_last_not_of("0123456789", name.find('.') == 0 ? 0 : name.find('.') - 1);
  if (end == std::string::npos || name[end] != 'w')
  {
    return {};
  }
  const auto named = [&](char letter)
  {
    std::string other = name;
    other[end] = letter;
    return beside(other);
  };
  return { named('d'), named('i'), named('j'), named('k'), 0.01 };
}

}

bool looksLikeNdbc(const std::string& firstLine)
{
  const std::vector<std::string> words = wordsOf(firstLine);
  if (words.size() < 4)
  {
    return false;
  }
  const std::string first = plain(words[0][0] == '#' ? words[0].substr(1) : words[0]);
  return (first == "yy" || first == "yyyy" || first == "yr") && (plain(words[1]) == "mm" || plain(words[1]) == "mo");
}

SpectrumFile readNdbcSpectra(const std::string& path)
{
  const Quantity density = Reader(path).read();
  const Family family = familyOf(path);
  std::error_code none;
  if (family.direction1.empty() || !fs::exists(family.direction1, none) || !fs::exists(family.length1, none))
  {
    throw std::runtime_error("'" + path + "' has no directions: the files " +
      (family.direction1.empty() ? "of the same buoy (46042w2010.txt with 46042d2010.txt, i, j and k, or .data_spec "
                                   "with .swdir, .swdir2, .swr1 and .swr2)"
                                 : "'" + family.direction1 + "' and '" + family.length1 + "'") +
      " must lie beside it");
  }
  const Quantity direction1 = Reader(family.direction1).read();
  const Quantity length1 = Reader(family.length1).read();
  const bool two = fs::exists(family.direction2, none) && fs::exists(family.length2, none);
  const Quantity direction2 = two ? Reader(family.direction2).read() : Quantity();
  const Quantity length2 = two ? Reader(family.length2).read() : Quantity();

  SpectrumFile file;
  file.format = "NDBC";
  SpectralGrid grid;
  grid.frequencies = density.frequencies;
  for (std::size_t j = 0; j < StandardDirections; ++j)
  {
    grid.headings.push_back(2.0 * Pi * static_cast<double>(j) / StandardDirections);
  }
  try
  {
    grid.validate();
  }
  catch (const std::invalid_argument& error)
  {
    throw std::runtime_error("'" + path + "': " + error.what());
  }
  const double width = 2.0 * Pi / StandardDirections;
  const auto at = [&](const Quantity& quantity, const std::string& time, std::size_t i)
  {
    const auto found = quantity.values.find(time);
    return found != quantity.values.end() && quantity.frequencies == grid.frequencies ? found->second[i] : NoValue;
  };
  std::size_t without = 0;
  std::size_t narrowed = 0;
  for (const auto& [time, values] : density.values)
  {
    SpectrumRecord record;
    record.time = time;
    record.spectrum.grid = grid;
    record.spectrum.density.assign(grid.size(), 0.0);
    bool whole = true;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      if (!(values[i] > 0.0))
      {
        continue; // nothing, or missing
      }
      const double heading = headingFromNautical(at(direction1, time, i));
      const double r1 = std::min(family.lengthFactor * at(length1, time, i), 0.995);
      if (std::isnan(heading) || !(r1 >= 0.0))
      {
        whole = false;
        break;
      }
      std::vector<double> shares;
      const double r2 = family.lengthFactor * at(length2, time, i);
      const double heading2 = headingFromNautical(at(direction2, time, i));
      if (r2 >= 0.0 && !std::isnan(heading2))
      {
        try
        {
          shares = MaximumEntropySpreading(r1, heading, r2, heading2).shares(grid.headings);
        }
        catch (const std::invalid_argument&)
        {
          ++narrowed; // moments that contradict each other: the first alone
        }
      }
      if (shares.empty())
      {
        const double spread = std::clamp(std::sqrt(2.0 * (1.0 - r1)), radians(1.0), radians(80.0));
        const auto spreading = DirectionalSpreading::cosinePower(spread);
        for (const double middle : grid.headings)
        {
          shares.push_back(spreading.share(1.0, middle - heading - 0.5 * width, middle - heading + 0.5 * width));
        }
      }
      for (std::size_t j = 0; j < StandardDirections; ++j)
      {
        record.spectrum.density[i * StandardDirections + j] = values[i] * shares[j] / width;
      }
    }
    if (whole)
    {
      file.records.push_back(std::move(record));
    }
    without += whole ? 0 : 1;
  }
  if (file.records.empty())
  {
    throw std::runtime_error("'" + path + "' and the files beside it have no time with directions");
  }
  if (without > 0)
  {
    file.notes.push_back(std::to_string(without) + " times have no directions and are left out");
  }
  if (narrowed > 0)
  {
    file.notes.push_back(std::to_string(narrowed) +
      " frequencies have second moments that contradict the first; they are spread by the first alone");
  }
  return file;
}

}
