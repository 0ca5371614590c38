#include "apps/view/Refinement.h"

#include <gtest/gtest.h>

using swellray::view::Refinement;

namespace
{

constexpr double Frame = 1.0 / 60.0;

}

TEST(Refinement, TracesFinelyAtOnceWhereThatFitsIntoAFrame)
{
  Refinement steps(Frame);
  steps.learn(16, 0.0005);
  EXPECT_EQ(steps.first(), 1); // 8 ms expected
  steps.learn(1, 0.012);
  EXPECT_EQ(steps.first(), 1);
}

TEST(Refinement, TracesCoarselyFirstAndFinerThen)
{
  Refinement steps(Frame);
  EXPECT_GT(steps.first(), 1); // nothing is known
  steps.learn(1, 0.1);
  EXPECT_EQ(steps.first(), 8); // 0.1 s over 8 is within a frame, over 4 it is not
  EXPECT_EQ(steps.next(8), 1); // a tenth of a second is no time
}

TEST(Refinement, RefinesInStepsOfAboutASecond)
{
  Refinement steps(Frame);
  steps.learn(1, 10.0);
  EXPECT_EQ(steps.first(), Refinement::Coarsest);
  EXPECT_EQ(steps.next(64), 16); // 10 s over 16 is below a second, over 8 it is not
  EXPECT_EQ(steps.next(16), 8);  // always finer
  EXPECT_EQ(steps.next(8), 4);
  EXPECT_EQ(steps.next(4), 2);
  EXPECT_EQ(steps.next(2), 1);
}

TEST(Refinement, BelievesWhatWasMeasured)
{
  Refinement steps(Frame);
  steps.learn(1, 0.1);
  steps.learn(8, 0.03); // not an eighth of it
  EXPECT_EQ(steps.first(), 16);
}
