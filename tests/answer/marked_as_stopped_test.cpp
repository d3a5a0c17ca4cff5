#include "answer/stopped_search.h"
#include "config/experiment_reader.h"
#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

class MarkedAsStopped : public testing::Test {
 protected:
  static Diagnosis sure() {
    Diagnosis diagnosis;
    diagnosis.probability = 0.9;
    diagnosis.calibrated = true;
    diagnosis.findings = {"a finding"};
    diagnosis.ranking.resize(1);
    return diagnosis;
  }

  TimeLimit limit_{60.0, "1 min"};
  const Stop work_{limit_};
};

TEST_F(MarkedAsStopped, StatesNoProbabilityAndSaysSoFirst) {
  Diagnosis diagnosis = sure();
  mark_stopped({"the search", {"drag @ body.arm", "spring @ joint.hinge"}, {}}, work_, 0, diagnosis);
  EXPECT_TRUE(std::isnan(diagnosis.probability));
  EXPECT_FALSE(diagnosis.calibrated);
  EXPECT_THAT(
      diagnosis.findings,
      ElementsAre("The search was stopped by --time-limit 1 min, during: the search.",
                  "The verdict is preliminary: it covers the candidates examined so far and states no probability.",
                  "Not examined: drag @ body.arm, spring @ joint.hinge.",
                  "Run the command again with a longer --time-limit, or without one.", "a finding"));
  ASSERT_TRUE(diagnosis.stopped);
  EXPECT_EQ(diagnosis.stopped->next, "Run the command again with a longer --time-limit, or without one.");
}

TEST_F(MarkedAsStopped, ContinuesWithTheModelsThatWereKept) {
  Diagnosis diagnosis = sure();
  mark_stopped({"the search", {}, {}}, work_, 3, diagnosis);
  EXPECT_EQ(diagnosis.stopped->next,
            "Run the same command again: it continues after 3 models that this call has finished.");
  EXPECT_THAT(diagnosis.findings, testing::Not(testing::Contains(testing::HasSubstr("Not examined"))));
}

TEST_F(MarkedAsStopped, SaysThatNoCandidateWasExaminedWhereNoneIsRanked) {
  Diagnosis nothing;
  mark_stopped({"the fit of the model", {}, {}}, work_, 0, nothing);
  EXPECT_EQ(nothing.findings[1], "No candidate was examined.");
}

/// A pendulum with one joint, on which each of these effects has one place.
class StoppedBeforeSearch : public MarkedAsStopped {
 protected:
  StoppedBeforeSearch() : experiment_(read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml")) {
    experiment_.model.effects = {};
    definition_ = define_model(experiment_, built_catalog());
  }
  Experiment experiment_;
  ModelDefinition definition_;
  const std::vector<std::string> among_ = {"coulomb_friction", "joint_spring"};
};

TEST_F(StoppedBeforeSearch, NamesEveryCandidateAtItsPlace) {
  EXPECT_THAT(candidate_names(experiment_, built_catalog(), definition_, among_),
              UnorderedElementsAre("coulomb_friction @ joint.hinge", "joint_spring @ joint.hinge"));
}

TEST_F(StoppedBeforeSearch, HasExaminedNothing) {
  const Diagnosis diagnosis =
      stopped_before_search(experiment_, built_catalog(), definition_, among_, "the checks of the data", work_);
  EXPECT_EQ(diagnosis.verdict, Verdict::cannot_tell);
  EXPECT_TRUE(diagnosis.ranking.empty());
  ASSERT_TRUE(diagnosis.stopped);
  EXPECT_EQ(diagnosis.stopped->during, "the checks of the data");
  EXPECT_EQ(diagnosis.stopped->not_examined.size(), 2U);
}

}  // namespace
}  // namespace lacuna
