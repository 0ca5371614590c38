// The checker checked: what passes, what an order is, what a picture holds.
#include "apps/validation/Case.h"
#include "apps/validation/Report.h"
#include "apps/validation/Svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <set>

namespace
{

using namespace swellray::validation;
using testing::HasSubstr;
using testing::Not;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

Plot plotOf(Series series)
{
  return { "title", "x", "y", { std::move(series) }, false, false };
}

TEST(Validation, PassesNothingThatIsNoNumber)
{
  EXPECT_TRUE((Check{ "", 1e-9, 1e-9, "" }.passed()));
  EXPECT_FALSE((Check{ "", 1.1e-9, 1e-9, "" }.passed()));
  EXPECT_FALSE((Check{ "", NotANumber, 1e-9, "" }.passed()));
  EXPECT_FALSE((Check{ "", Infinity, 1e-9, "" }.passed()));
  EXPECT_TRUE((Check{ "", 2.9, 2.9, "", Check::Ask::AtLeast }.passed()));
  EXPECT_FALSE((Check{ "", 2.8, 2.9, "", Check::Ask::AtLeast }.passed()));
  EXPECT_FALSE((Check{ "", NotANumber, 2.9, "", Check::Ask::AtLeast }.passed()));
  EXPECT_TRUE((Check{ "", NotANumber, 0.0, "", Check::Ask::Nothing }.passed()));
}

TEST(Validation, FailsACaseByAnyOneCheckAndByNone)
{
  Outcome outcome;
  EXPECT_FALSE(outcome.passed()); // nothing was looked at
  outcome.checks = { { "good", 0.0, 1.0, "" } };
  EXPECT_TRUE(outcome.passed());
  outcome.checks.push_back({ "bad", 2.0, 1.0, "" });
  EXPECT_FALSE(outcome.passed());
}

TEST(Validation, FitsTheOrderOfAPower)
{
  std::vector<double> sizes;
  std::vector<double> errors;
  for (const double size : { 8.0, 4.0, 2.0, 1.0 })
  {
    sizes.push_back(size);
    errors.push_back(0.3 * std::pow(size, 2.5));
  }
  constexpr double rounding = 1e-12;
  EXPECT_NEAR(fittedOrder(sizes, errors), 2.5, rounding);
  errors[2] = 0.0;
  EXPECT_TRUE(std::isnan(fittedOrder(sizes, errors)));
  errors[2] = NotANumber;
  EXPECT_TRUE(std::isnan(fittedOrder(sizes, errors)));
}

TEST(Validation, NamesEveryCaseOnce)
{
  std::set<std::string> names;
  for (const Case& one : allCases())
  {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_FALSE(one.title.empty()) << one.name;
    EXPECT_FALSE(one.about.empty()) << one.name;
  }
  for (const char* stem : { "c1_dispersion", "c1_shoaling", "c2_deep_to_depth", "c2_plane_A", "c2_plane_B",
         "c2_plane_C_deep70", "c3_design_circle", "c3_design_cycloid", "c3_design_fold_parabola", "c3_design_luneburg",
         "c3_design_parabola_island", "c3_design_spiral_island", "c3_shallow_island_cone", "c3_shallow_island_par",
         "c3_shallow_plane_cycloid", "c3_shallow_x2_circle", "c4_island_cone", "c4_island_parabolic", "c4_shoal_gauss",
         "c4_shoal_gauss_caustic", "c4_shoal_poly3", "c4_shoal_poly3_caustic", "c5_bar_A", "c5_dean_A",
         "c5_trapped_plane_1", "c5_trapped_plane_2", "c6_breaking", "c7a_fold_airy", "c7b_luneburg_wave",
         "c7b_shoal_poly3_wave", "c7c_berkhoff_caustic", "c7c_berkhoff_rays", "c8_jet_1", "c8_jet_2", "c8_jet_3",
         "c8_jet_4", "c8_collinear", "c8_eddy" })
  {
    EXPECT_EQ(names.count(stem), 1u) << stem;
  }
}

TEST(Validation, HasACaseForEveryReferenceTable)
{
  const char* data = std::getenv("SWELLRAY_DATA");
  const auto folder = std::filesystem::path(data ? data : SWELLRAY_DATA_DEFAULT).parent_path() / "reference";
  if (!std::filesystem::is_directory(folder))
  {
    GTEST_SKIP() << "no reference tables in " << folder;
  }
  const std::vector<Case> cases = allCases();
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    if (entry.path().extension() == ".csv")
    {
      const std::string stem = entry.path().stem().string();
      EXPECT_TRUE(std::any_of(
        cases.begin(), cases.end(), [&stem](const Case& one) { return one.name.find(stem) != std::string::npos; }))
        << stem;
    }
  }
}

TEST(Validation, DrawsWhatCanBeDrawn)
{
  const std::string dots =
    drawSvg({ plotOf({ "a < b & 'c'", Series::Look::Dots, { 0.0, 1.0, 2.0 }, { 1.0, NotANumber, 3.0 } }) });
  EXPECT_THAT(dots, HasSubstr("a &lt; b &amp; &#39;c&#39;"));
  EXPECT_THAT(dots, Not(HasSubstr("nan")));
  std::size_t circles = 0;
  for (std::size_t at = dots.find("<circle"); at != std::string::npos; at = dots.find("<circle", at + 1))
  {
    ++circles;
  }
  EXPECT_EQ(circles, 3u); // two points and the sample in the legend

  // A line breaks where a value is missing: two strokes begin.
  const std::string line =
    drawSvg({ plotOf({ "", Series::Look::Line, { 0.0, 1.0, 2.0, 3.0, 4.0 }, { 0.0, 1.0, NotANumber, 1.0, 0.0 } }) });
  const std::size_t path = line.find("stroke-width");
  const std::size_t begin = line.rfind("<path", path);
  const std::string strokes = line.substr(begin, path - begin);
  EXPECT_EQ(std::count(strokes.begin(), strokes.end(), 'M'), 2);

  // Values of one size, none at all, and none that a logarithm takes.
  Plot flat = plotOf({ "", Series::Look::Line, { 1.0, 1.0 }, { 0.0, 0.0 } });
  EXPECT_THAT(drawSvg({ flat }), Not(HasSubstr("nan")));
  flat.logarithmic = true;
  EXPECT_THAT(drawSvg({ flat }), Not(HasSubstr("inf")));
  EXPECT_THAT(drawSvg({ plotOf({}) }), Not(HasSubstr("nan")));
}

TEST(Validation, ReportsFailuresInEveryFile)
{
  Finding finding;
  finding.what = { "c0_test", "A <test>", "h = x", {} };
  finding.outcome.checks = { { "depth, \"m\"", 2.0, 1.0, "because" }, { "shown", 5.0, 0.0, "", Check::Ask::Nothing } };
  finding.outcome.plots = { plotOf({ "", Series::Look::Line, { 0.0, 1.0 }, { 0.0, 1.0 } }) };
  finding.outcome.numbers = { { "a", "b" }, { { 0.1, 2.0 } } };
  std::set<std::string> names;
  for (const ReportFile& file : makeReport({ finding }, { "swellray 0", "swellray validate", true }))
  {
    names.insert(file.name);
    if (file.name == "index.html")
    {
      EXPECT_THAT(file.text, HasSubstr("1 of 1 cases fail"));
      EXPECT_THAT(file.text, HasSubstr("A &lt;test&gt;"));
      EXPECT_THAT(file.text, HasSubstr("made wrong on purpose"));
      EXPECT_THAT(file.text, HasSubstr("<svg"));
    }
    else if (file.name == "checks.csv")
    {
      EXPECT_THAT(file.text, HasSubstr("c0_test,\"depth, \"\"m\"\"\",2,1,at most,FAIL,\"because\"\n"));
    }
    else if (file.name == "c0_test.csv")
    {
      EXPECT_EQ(file.text, "a,b\n0.10000000000000001,2\n");
    }
  }
  EXPECT_EQ(names, (std::set<std::string>{ "index.html", "checks.csv", "c0_test.csv", "c0_test.svg" }));
}

}
