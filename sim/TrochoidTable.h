#pragma once

#include <vector>

namespace swellray
{

/**
 * Profile of Gerstner's wave (1804) over its phase, out of a table:
 *
 *   x = x0 - r sin(k x0),  z = r cos(k x0)
 *
 * as a function of k x, less its mean and scaled to the mean square of a cosine, 1/2: a crest stands at phase 0, sharper
 * the larger the steepness k r. 0 is a cosine, 1 a cusp. Errors of interpolation are below 1e-3 up to k r = 0.9.
 */
class TrochoidTable
{
public:
  TrochoidTable();

  /** Profile at a phase. @param phase rad, any @param steepness k r, 0 to 1; beyond it is held */
  double value(double phase, double steepness) const;

private:
  struct Node
  {
    double value = 0.0;
    double slope = 0.0; // by the phase
  };
  std::vector<Node> Nodes; // [steepness][phase], one node more than a period
};

}
