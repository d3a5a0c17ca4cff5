#include "config/decided.h"

#include "foundation/text/problem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Decided, IsWhatTheFileLeavesOpen) {
  Experiment experiment;
  decide_engine(experiment, "articulated");
  decide_substeps(experiment, 3);
  EXPECT_EQ(experiment.engine.engine, "articulated");
  EXPECT_EQ(experiment.engine.substeps, 3);
  EXPECT_THAT(experiment.decided, ElementsAre("engine.engine=\"articulated\"", "engine.substeps=3"));
  EXPECT_TRUE(substeps_decided(experiment));
}

TEST(Decided, LeavesWhatTheFileSays) {
  Experiment experiment;
  experiment.engine.engine = "ode";
  experiment.engine.substeps = 8;
  decide_engine(experiment, "articulated");
  decide_substeps(experiment, 3);
  EXPECT_EQ(experiment.engine.engine, "ode");
  EXPECT_EQ(experiment.engine.substeps, 8);
  EXPECT_THAT(experiment.decided, IsEmpty());
  EXPECT_FALSE(substeps_decided(experiment));
}

TEST(Decided, IsReplayed) {
  Experiment first, second;
  decide_engine(first, "articulated");
  decide_substeps(first, 3);
  decide_as(second, first.decided);
  EXPECT_EQ(second.engine.engine, "articulated");
  EXPECT_EQ(second.engine.substeps, 3);
  EXPECT_EQ(second.decided, first.decided);
}

TEST(Decided, ThatIsNoDecisionIsRefused) {
  Experiment experiment;
  EXPECT_THROW(decide_as(experiment, {"engine.engine=\"odd\""}), BadInput);
  EXPECT_THROW(decide_as(experiment, {"engine.substeps=\"many\""}), BadInput);
}

}  // namespace
}  // namespace lacuna
