#include "Sweep.h"

#include "Csv.h"
#include "Failure.h"
#include "OutputFile.h"
#include "ShellWords.h"
#include "Values.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>

namespace swellray::cli
{

namespace
{

namespace fs = std::filesystem;

constexpr std::size_t MostCases = 10000;

// Outputs of which each case has its own, and how they are typed.
struct OutputName
{
  const char* option;
  const char* shortOption;
  std::string OutputRequest::*file;
};

const OutputName OutputNames[] = { { "--output", "-o", &OutputRequest::file },
  { "--crests", "", &OutputRequest::crests }, { "--breaker-line", "", &OutputRequest::breakerLine },
  { "--map", "", &OutputRequest::map }, { "--table", "", &OutputRequest::table },
  { "--spectra", "", &OutputRequest::spectra }, { "--elevation-series", "", &OutputRequest::elevations } };

std::vector<std::string> split(const std::string& text, char separator)
{
  std::vector<std::string> parts(1);
  for (const char c : text)
  {
    if (c == separator)
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += c;
    }
  }
  return parts;
}

std::string withSuffix(const std::string& file, const std::string& suffix)
{
  const fs::path path(file);
  return (path.parent_path() / (path.stem().string() + suffix + path.extension().string())).string();
}

// Put a value in place of that of an option; where the line has none, a file gave it, and it is added.
void replaceValue(
  std::vector<std::string>& words, const std::string& option, const std::string& shortOption, const std::string& value)
{
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    if ((words[i] == option || (!shortOption.empty() && words[i] == shortOption)) && i + 1 < words.size())
    {
      words[i + 1] = value;
      return;
    }
    if (words[i].rfind(option + "=", 0) == 0)
    {
      words[i] = option + "=" + value;
      return;
    }
  }
  words.push_back(option);
  words.push_back(value);
}

// Leave out what makes no other result.
void dropIdle(std::vector<std::string>& words)
{
  for (std::size_t i = 0; i < words.size();)
  {
    const bool two = words[i] == "--threads" && i + 1 < words.size();
    const bool idle = two || words[i] == "--quiet" || words[i].rfind("--threads=", 0) == 0;
    const auto at = words.begin() + static_cast<std::ptrdiff_t>(i);
    i += idle ? 0 : 1;
    if (idle)
    {
      words.erase(at, at + (two ? 2 : 1));
    }
  }
}

std::vector<std::string> filesOf(const Request& request)
{
  std::vector<std::string> files;
  for (const OutputName& name : OutputNames)
  {
    if (!(request.output.*name.file).empty())
    {
      files.push_back(request.output.*name.file);
    }
  }
  return files;
}

std::string inQuotes(const std::string& text)
{
  std::string result = "\"";
  for (const char c : text)
  {
    result += c == '"' ? std::string("\"\"") : std::string(1, c == '\n' ? ' ' : c);
  }
  return result + "\"";
}

// What the cases are, which of them are done, and how long they took.
class CaseTable
{
public:
  explicit CaseTable(const std::string& path)
    : Path(path)
  {
    std::error_code none;
    if (!fs::exists(path, none))
    {
      return;
    }
    for (const CsvLine& line : readCsv(path))
    {
      if (line.fields.size() >= 3 && line.fields[line.fields.size() - 3] == "done")
      {
        this->Done[line.fields.back()] = line.text;
      }
    }
  }

  /** A case of this very call that is whole. */
  bool isDone(const Request& request) const
  {
    if (!this->Done.count(request.commandLine))
    {
      return false;
    }
    const auto files = filesOf(request);
    std::error_code none;
    return std::all_of(files.begin(), files.end(),
      [&](const std::string& file) { return fs::is_regular_file(file, none) && fs::file_size(file, none) > 0; });
  }

  void keep(const Request& request)
  {
    this->Rows.push_back(this->Done.at(request.commandLine));
    this->Done.erase(request.commandLine);
  }

  void add(const Request& request, const std::string& state, double seconds)
  {
    this->Done.erase(request.commandLine);
    std::string row;
    for (const auto& [option, value] : request.variation)
    {
      row += value + ",";
    }
    std::string files;
    for (const std::string& file : filesOf(request))
    {
      files += (files.empty() ? "" : " ") + file;
    }
    this->Rows.push_back(
      row + inQuotes(files) + "," + state + fmt::format(",{:.3g},", seconds) + inQuotes(request.commandLine));
  }

  /** The cases so far, and those that were done before and are still to come. */
  void write(const Request& first) const
  {
    OutputFile file(this->Path, {});
    std::ofstream table(file.temporary(), std::ios::trunc);
    for (const auto& [option, value] : first.variation)
    {
      table << option << ',';
    }
    table << "files,state,seconds,command\n";
    for (const std::string& row : this->Rows)
    {
      table << row << '\n';
    }
    for (const auto& [command, row] : this->Done)
    {
      table << row << '\n';
    }
    table.close();
    if (!table)
    {
      file.fail("the disk is full, or files may not get so large");
    }
    file.commit();
  }

private:
  std::string Path;
  std::map<std::string, std::string> Done; // rows by command lines
  std::vector<std::string> Rows;
};

// The station tables of the cases as one, with what varies in front.
void mergeTables(const std::string& path, const std::vector<const Request*>& cases)
{
  OutputFile file(path, {});
  std::ofstream merged(file.temporary(), std::ios::trunc);
  bool first = true;
  for (const Request* request : cases)
  {
    std::ifstream table(request->output.table);
    std::string front;
    std::string names;
    for (const auto& [option, value] : request->variation)
    {
      names += option + ",";
      front += value + ",";
    }
    std::string line;
    for (std::size_t number = 0; std::getline(table, line); ++number)
    {
      if (number > 0 || first)
      {
        merged << (number == 0 ? names : front) << line << '\n';
      }
    }
    first = false;
  }
  merged.close();
  if (!merged)
  {
    file.fail("the disk is full, or files may not get so large");
  }
  file.commit();
}

std::string wordsOf(const Request& request)
{
  std::string words;
  for (const auto& [option, value] : request.variation)
  {
    words += (words.empty() ? "" : ", ") + option + " " + value;
  }
  return words;
}

}

void allowLists(std::vector<OptionSpec>& options, const std::vector<std::string>& names)
{
  for (OptionSpec& option : options)
  {
    if (std::find(names.begin(), names.end(), option.longName()) != names.end())
    {
      option.takesLists = true;
      option.help += "; a list or FROM:TO:STEP makes a sweep";
    }
  }
}

bool isList(const std::string& text)
{
  return text.find_first_of(",:") != std::string::npos;
}

std::vector<std::string> expandList(const std::string& option, const std::string& text)
{
  std::vector<std::string> values;
  for (const std::string& part : split(text, ','))
  {
    const auto ends = split(part, ':');
    if (ends.size() == 1)
    {
      values.push_back(fmt::format("{:.12g}", parseNumber(option, part, {})));
      continue;
    }
    std::vector<double> numbers;
    for (const std::string& end : ends)
    {
      numbers.push_back(parseNumber(option, end, {}));
    }
    if (numbers.size() != 3 || !(numbers[2] > 0.0) || !(numbers[1] >= numbers[0]))
    {
      throw UsageError(fmt::format("{} needs FROM:TO:STEP with FROM <= TO and STEP > 0, not '{}'", option, part));
    }
    constexpr double Rounding = 1e-9;
    const double steps = std::floor((numbers[1] - numbers[0]) / numbers[2] + Rounding);
    if (!(steps < static_cast<double>(MostCases)))
    {
      throw UsageError(fmt::format("{} has more than {} values; take a larger step", option, MostCases));
    }
    for (int i = 0; i <= static_cast<int>(steps); ++i)
    {
      values.push_back(fmt::format("{:.12g}", numbers[0] + i * numbers[2]));
    }
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (std::find(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(i), values[i]) !=
      values.begin() + static_cast<std::ptrdiff_t>(i))
    {
      throw UsageError(fmt::format("{} has {} twice in '{}'", option, values[i], text));
    }
  }
  return values;
}

std::size_t caseCount(const std::vector<SweepAxis>& axes)
{
  std::size_t count = 1;
  for (const SweepAxis& axis : axes)
  {
    count *= axis.values.size();
    if (count > MostCases)
    {
      throw UsageError(fmt::format("a sweep of more than {} cases; take shorter lists", MostCases));
    }
  }
  return count;
}

const std::string& caseValue(const std::vector<SweepAxis>& axes, std::size_t axis, std::size_t index)
{
  for (std::size_t other = axes.size() - 1; other > axis; --other)
  {
    index /= axes[other].values.size();
  }
  return axes[axis].values[index % axes[axis].values.size()];
}

void becomeCase(Request& request, const std::vector<SweepAxis>& axes, std::size_t index)
{
  std::vector<std::string> words = splitWords(request.commandLine);
  std::string suffix;
  std::string levelSuffix; // rays that are kept depend on the water level alone of what may vary
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
  {
    const std::string& value = caseValue(axes, axis, index);
    std::string name = axes[axis].option.substr(2);
    request.variation.emplace_back(name, value);
    replaceValue(words, axes[axis].option, "", value);
    name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
    suffix += "_" + name + value;
    levelSuffix += axes[axis].option == "--water-level" ? "_" + name + value : "";
  }
  for (const OutputName& output : OutputNames)
  {
    std::string& file = request.output.*output.file;
    if (!file.empty())
    {
      file = withSuffix(file, suffix);
      replaceValue(words, output.option, output.shortOption, file);
    }
  }
  if (!request.spectrum.transfer.empty() && !levelSuffix.empty())
  {
    request.spectrum.transfer = withSuffix(request.spectrum.transfer, levelSuffix);
    replaceValue(words, "--transfer", "", request.spectrum.transfer);
  }
  dropIdle(words);
  request.commandLine = joinWords(words);
}

void runSweep(const Request& asked, const std::vector<Request>& cases,
  const std::function<void(const Request&, Console&)>& run, Console& console)
{
  const auto named = filesOf(asked);
  const fs::path first(named.empty() ? "sweep" : named.front());
  const std::string tableName = (first.parent_path() / (first.stem().string() + ".cases.csv")).string();
  CaseTable table(tableName);
  std::vector<const Request*> whole;
  std::optional<std::string> failure;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    const Request& request = cases[i];
    const std::string what = fmt::format("case     {} of {}: {}", i + 1, cases.size(), wordsOf(request));
    if (table.isDone(request))
    {
      console.say(what + ", kept");
      table.keep(request);
      whole.push_back(&request);
      ++kept;
      continue;
    }
    console.say(what);
    const auto start = std::chrono::steady_clock::now();
    try
    {
      run(request, console);
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
      table.add(request, "done", took.count());
      whole.push_back(&request);
    }
    catch (const WorkError& error)
    {
      console.warn(fmt::format("{}: {}", wordsOf(request), error.what()));
      failure = failure.value_or(fmt::format("{}: {}", wordsOf(request), error.what()));
      table.add(request, "failed", 0.0);
    }
    table.write(cases.front());
  }
  table.write(cases.front());
  if (!asked.output.table.empty())
  {
    mergeTables(asked.output.table, whole);
  }
  console.say(fmt::format("sweep    {} cases: {} run, {} kept, {} failed; {}", cases.size(), whole.size() - kept, kept,
    cases.size() - whole.size(), tableName));
  if (failure)
  {
    throw WorkError(fmt::format("{} of {} cases failed; {}", cases.size() - whole.size(), cases.size(), *failure));
  }
}

}
