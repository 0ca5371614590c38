#pragma once

#include "sim/IncidentWave.h"

#include <functional>
#include <string>
#include <vector>

/** Cases with known answers: what they compute, how far off it is, and how far off it may be. */
namespace swellray::validation
{

/** One quantity of a case. */
struct Check
{
  /** What is asked of the value. */
  enum class Ask
  {
    AtMost,  ///< an error: not above the limit
    AtLeast, ///< an order of convergence: not below the limit
    Nothing, ///< shown beside the others
  };

  std::string quantity; ///< with its unit
  double value = 0.0;   ///< NaN: could not be found, which passes nothing that is asked
  double limit = 0.0;
  std::string reason; ///< where the limit comes from, one phrase
  Ask ask = Ask::AtMost;

  bool passed() const
  {
    return this->ask == Ask::Nothing || (this->ask == Ask::AtMost ? value <= limit : value >= limit);
  }
};

/** Numbers to draw: a line, or dots. */
struct Series
{
  enum class Look
  {
    Line,
    Dashes,
    Dots,
    Crosses,
  };

  std::string name;
  Look look = Look::Line;
  std::vector<double> x;
  std::vector<double> y; ///< NaN breaks a line

  void add(double atX, double atY)
  {
    this->x.push_back(atX);
    this->y.push_back(atY);
  }
};

struct Plot
{
  std::string title;
  std::string xLabel;
  std::string yLabel;
  std::vector<Series> series;
  bool logarithmic = false; ///< both axes
  bool equalScales = false; ///< a map
};

/** Numbers of a case: rows of as many values as there are columns. */
struct Table
{
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
};

struct Outcome
{
  std::vector<Check> checks;
  std::vector<Plot> plots;
  Table numbers;
  Table grids; ///< errors over the spacing of a grid, as they are plotted; may be empty

  bool passed() const
  {
    bool all = !this->checks.empty();
    for (const Check& check : this->checks)
    {
      all = all && check.passed();
    }
    return all;
  }
};

/** How a case is run. */
struct Setting
{
  bool quick = false; ///< leave out the parts that take long
  // Of the computed side alone: other values must make cases fail.
  double gravity = StandardGravity; ///< m/s2
  double bedSlope = 1.0;            ///< factor of the bed's gradient: rays bend wrongly
  double bedCurvature = 1.0;        ///< factor of its second derivatives: tubes widen wrongly
};

struct Case
{
  std::string name;
  std::string title;
  std::string about; ///< formula, parameters and source of the exact side
  std::function<Outcome(const Setting&)> run;
};

/** Every case, family by family. */
std::vector<Case> allCases();

/** The order p of errors ~ size^p: slope of the straight line fitted in logarithms; NaN where an error is not above 0. */
double fittedOrder(const std::vector<double>& sizes, const std::vector<double>& errors);

/** The line of that order through the middle of the dots, in logarithms. */
Series fittedLine(const Series& dots, double order);

}
