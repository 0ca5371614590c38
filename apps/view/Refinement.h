#pragma once

#include <map>

namespace swellray::view
{

/**
 * How coarsely to trace while a slider moves, and how to refine when it rests.
 *
 * A coarseness is the distance of rays over that of the finest trace, 1, 2, 4, ... up to Coarsest. The time of a trace
 * is taken to go with the number of rays; what was measured last goes first.
 */
class Refinement
{
public:
  static constexpr int Coarsest = 64;

  /** @param frame time in which a first trace has to be done, s, > 0 */
  explicit Refinement(double frame);

  /** Coarseness of the first trace of a wave: the finest that fits into a frame, as far as is known. */
  int first() const;

  /** The next finer one: at most so much finer that something new is seen within about a second. */
  int next(int coarseness) const;

  /** A trace of this coarseness took so long, s. */
  void learn(int coarseness, double seconds);

private:
  double expected(int coarseness) const;

  double Frame;
  std::map<int, double> Seconds; // by coarseness
};

}
