#pragma once

#include "Case.h"

namespace swellray::validation
{

/** A case that was run. */
struct Finding
{
  Case what;
  Outcome outcome;
  double seconds = 0.0;
};

/** What the report says of the run as a whole. */
struct ReportHead
{
  std::string version;
  std::string commandLine;
  bool perturbed = false; ///< run with a formula made wrong on purpose
};

/** One file of the report. */
struct ReportFile
{
  std::string name;
  std::string text;
};

/** index.html, checks.csv, and a .svg and a .csv a case. */
std::vector<ReportFile> makeReport(const std::vector<Finding>& findings, const ReportHead& head);

/** "3.1e-10", or a count as it is. */
std::string formatValue(double value);

/** The limit as a reader understands it: "<= 3e-09", ">= 2.9", or "-". */
std::string formatLimit(const Check& check);

/** "pass", "FAIL" or "shown". */
std::string verdictOf(const Check& check);

}
