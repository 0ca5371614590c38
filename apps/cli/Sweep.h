#pragma once

#include "Options.h"

#include <string>
#include <vector>

namespace swellray::cli
{

/** An option that is varied, and its values as they would be typed. */
struct SweepAxis
{
  std::string option; ///< long name
  std::vector<std::string> values;
};

/** Let these options of a command take lists. */
void allowLists(std::vector<OptionSpec>& options, const std::vector<std::string>& names);

/** True for a list: 8,12,16 or FROM:TO:STEP, or several of these with commas between. */
bool isList(const std::string& text);

/** The values of a list. @throws UsageError naming the option */
std::vector<std::string> expandList(const std::string& option, const std::string& text);

/** Number of cases. @throws UsageError where they are too many */
std::size_t caseCount(const std::vector<SweepAxis>& axes);

/** Value of an axis in a case; the last axis varies fastest. */
const std::string& caseValue(const std::vector<SweepAxis>& axes, std::size_t axis, std::size_t index);

/**
 * Make a request that of one case: its outputs get names that tell it, and its command line is that of this case alone.
 */
void becomeCase(Request& request, const std::vector<SweepAxis>& axes, std::size_t index);

/**
 * Run cases one after the other. Those that a table beside the outputs (NAME.cases.csv) tells to be done, by their own command
 * lines, and of which the files are there, are passed over; so a sweep that was broken off goes on. A case that fails does
 * not keep the others from being run. Station tables of all cases are put together into the one that was asked for.
 * @param asked the request with the names of outputs as typed
 * @throws WorkError where a case failed
 */
void runSweep(const Request& asked, const std::vector<Request>& cases,
  const std::function<void(const Request&, Console&)>& run, Console& console);

}
