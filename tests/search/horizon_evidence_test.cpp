#include "search/horizon_evidence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

HorizonErrors errors_of(double shorter, double longer) {
  HorizonErrors errors;
  errors.valid = true;
  errors.weight = {{0.5}, {0.5}};
  errors.mean_square = {{shorter * shorter}, {longer * longer}};
  return errors;
}

RankedSet set_of(const std::vector<std::string>& effects, double nats, double error) {
  RankedSet set;
  for (const std::string& effect : effects) {
    EffectEntry entry;
    entry.effect = effect;
    entry.where = {"joint.hinge"};
    set.model.added.push_back(entry);
  }
  set.over_answer = {nats, error};
  set.errors = errors_of(2.0, 8.0);
  return set;
}

/// Dry friction first; a richer law does the same, viscous friction does not.
Missing friction_found() {
  Missing missing;
  missing.ladder.channels.resize(1);
  missing.ladder.rungs.resize(2);
  for (Rung& rung : missing.ladder.rungs) {
    rung.floor = {1.0};
    rung.weight = {0.5};
  }
  missing.base.errors = errors_of(4.0, 64.0);
  missing.ranking = {set_of({"coulomb_friction"}, 0.0, 0.0), set_of({"stribeck_friction"}, 0.01, 0.1),
                     set_of({"coulomb_friction", "cogging"}, -0.02, 0.1), set_of({"viscous_friction"}, 0.9, 0.3)};
  missing.alike = {"stribeck_friction @ joint.hinge"};
  missing.ranking.front().over_base = {1.4, 0.2};
  return missing;
}

TEST(HorizonEvidence, LeadsOverSetsThatSaySomethingElse) {
  EXPECT_NEAR(evidence_of(friction_found(), {}).at("lead"), 3.0, 1e-12);
}

TEST(HorizonEvidence, LeadsOverSetsWithNoMoreValues) {
  Missing missing = friction_found();
  missing.ranking.push_back(set_of({"viscous_friction", "joint_spring", "cogging"}, -0.1, 0.1));
  missing.ranking.back().model.definition.free.resize(3);
  EXPECT_NEAR(evidence_of(missing, {}).at("lead"), 3.0, 1e-12);
}

TEST(HorizonEvidence, TellsWhatIsLeftAboveTheFloor) {
  EXPECT_NEAR(evidence_of(friction_found(), {}).at("left"), std::log(4.0) / std::log(16.0), 1e-12);
  EXPECT_NEAR(evidence_of(friction_found(), {}).at("sureness"), 7.0, 1e-12);
}

TEST(HorizonEvidence, IsOfAnAnswerAlone) {
  Missing missing = friction_found();
  missing.ranking.front().model.added.clear();
  EXPECT_TRUE(evidence_of(missing, {}).empty());
}

}  // namespace
}  // namespace lacuna
