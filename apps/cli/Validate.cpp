#include "Commands.h"
#include "Failure.h"
#include "OptionKinds.h"
#include "OutputFile.h"
#include "Values.h"
#include "Version.h"

#include "apps/validation/Case.h"
#include "apps/validation/Report.h"
#include "sim/forms/NearestWord.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>

namespace swellray::cli
{

namespace
{

using validation::Case;
using validation::Check;
using validation::Finding;

constexpr const char* RowFormat = "{:<28} {:<40} {:>9} {:>11}  {}";

/** The cases whose names begin with one of the words; all where there are none. */
std::vector<Case> chosenCases(const std::vector<std::string>& words)
{
  std::vector<Case> all = validation::allCases();
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const Case& one : all)
  {
    names.push_back(one.name);
  }
  for (const std::string& word : words)
  {
    if (std::none_of(names.begin(), names.end(), [&](const std::string& name) { return name.rfind(word, 0) == 0; }))
    {
      throw UsageError(
        fmt::format("no case begins with '{}'; did you mean '{}'? (see --list)", word, nearestWord(word, names)));
    }
  }
  std::vector<Case> chosen;
  for (Case& one : all)
  {
    const bool wanted = words.empty() ||
      std::any_of(words.begin(), words.end(), [&](const std::string& word) { return one.name.rfind(word, 0) == 0; });
    if (wanted)
    {
      chosen.push_back(std::move(one));
    }
  }
  return chosen;
}

void say(const Finding& finding, const Console& console)
{
  for (const Check& check : finding.outcome.checks)
  {
    console.say(fmt::format(RowFormat, finding.what.name, check.quantity, validation::formatValue(check.value),
      validation::formatLimit(check), validation::verdictOf(check)));
  }
}

/** Folder of a report, known to be writable before the work begins. */
class ReportFolder
{
public:
  explicit ReportFolder(const std::string& path)
    : Path(path)
  {
    std::error_code error;
    std::filesystem::create_directories(this->Path, error);
    if (error)
    {
      throw WorkError(fmt::format("cannot make the folder '{}': {}", path, error.message()));
    }
    this->Index = std::make_unique<OutputFile>((this->Path / IndexName).string(), std::vector<std::string>{});
  }

  void write(const std::vector<validation::ReportFile>& files)
  {
    for (const validation::ReportFile& file : files)
    {
      if (file.name != IndexName)
      {
        OutputFile output((this->Path / file.name).string(), {});
        fill(output, file.text);
      }
    }
    // The page comes last, when all that it names is there.
    for (const validation::ReportFile& file : files)
    {
      if (file.name == IndexName)
      {
        fill(*this->Index, file.text);
      }
    }
  }

  std::string index() const { return this->Index->path(); }

private:
  static constexpr const char* IndexName = "index.html";

  static void fill(OutputFile& output, const std::string& text)
  {
    std::ofstream file(output.temporary(), std::ios::binary);
    file << text;
    file.close();
    if (!file)
    {
      output.fail("the disk is full, or files may not get so large");
    }
    output.commit();
  }

  std::filesystem::path Path;
  std::unique_ptr<OutputFile> Index;
};

// Enough for any case to notice.
const NumberRule Perturbation{ "", -0.5, 0.5 };

void runValidate(const Request& request, Console& console)
{
  const ValidateRequest& wanted = request.validate;
  const std::vector<Case> cases = chosenCases(wanted.cases);
  if (wanted.list)
  {
    for (const Case& one : cases)
    {
      std::printf("%s\n", fmt::format("{:<28} {}", one.name, one.title).c_str());
    }
    return;
  }
  std::unique_ptr<ReportFolder> folder;
  if (!wanted.report.empty())
  {
    folder = std::make_unique<ReportFolder>(wanted.report);
  }
  validation::Setting setting;
  const double factor = 1.0 + wanted.perturb;
  switch (wanted.perturbed)
  {
  case ValidateRequest::Formula::Dispersion:
    setting.gravity *= factor;
    break;
  case ValidateRequest::Formula::Bending:
    setting.bedSlope = factor;
    break;
  case ValidateRequest::Formula::Tube:
    setting.bedCurvature = factor;
    break;
  }
  setting.quick = wanted.quick;

  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::time_point since)
  { return std::chrono::duration<double>(Clock::now() - since).count(); };
  const auto start = Clock::now();
  std::vector<Finding> findings;
  std::vector<std::string> failed;
  std::size_t checks = 0;
  console.say(fmt::format(RowFormat, "case", "quantity", "found", "tolerance", "verdict"));
  for (const Case& one : cases)
  {
    console.progress("validate", static_cast<double>(findings.size()) / static_cast<double>(cases.size()));
    const auto began = Clock::now();
    Finding finding{ one, one.run(setting), 0.0 };
    finding.seconds = seconds(began);
    console.endProgress();
    say(finding, console);
    checks += finding.outcome.checks.size();
    if (!finding.outcome.passed())
    {
      failed.push_back(one.name);
    }
    findings.push_back(std::move(finding));
  }
  console.say(fmt::format(
    "{} cases, {} quantities, {} cases failed, {:.1f} s", cases.size(), checks, failed.size(), seconds(start)));
  if (folder)
  {
    const std::string version = versionText();
    folder->write(validation::makeReport(
      findings, { version.substr(0, version.find('\n')), request.commandLine, wanted.perturb != 0.0 }));
    console.say(fmt::format("wrote {}", folder->index()));
  }
  if (!failed.empty())
  {
    throw WorkError(fmt::format("{} of {} cases failed: {}", failed.size(), cases.size(), fmt::join(failed, ", ")));
  }
}

}

CommandSpec validateSpec(Request& request)
{
  CommandSpec spec{ "validate", "compute the cases with known answers and say how far off they are", false, {}, {} };
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
    number("--perturb", "E", "make a formula wrong by this share, to check the checker: cases must fail", "0", group,
      validate.perturb, Perturbation),
    choice("--perturb-in", "which: gravity in the dispersion relation, or the bed's slope or curvature", "gravity",
      group, validate.perturbed,
      std::vector<std::pair<std::string, ValidateRequest::Formula>>{
        { "gravity", ValidateRequest::Formula::Dispersion }, { "slope", ValidateRequest::Formula::Bending },
        { "curvature", ValidateRequest::Formula::Tube } }),
    text("--report", "DIR", "write index.html, a picture and the numbers of each case to this folder", "", "Output",
      validate.report) };
  spec.examples = "  swellray validate\n"
                  "  swellray validate --quick --report report\n"
                  "  swellray validate --case c2_plane --case c4_shoal_gauss\n"
                  "  swellray validate --quick --perturb 1e-3     # must fail: exit code 1\n";
  spec.run = runValidate;
  return spec;
}

}
