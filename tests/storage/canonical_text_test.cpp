#include "storage/small_database.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace lacuna {
namespace {

using test::friction;
using test::revision_with;

Trial some_trial() {
  Trial trial;
  trial.name = "sine";
  trial.measured = test::sine(10);
  trial.commands.series = test::sine(10, 2.0);
  trial.commands.series.channels = {{"motor", "N*m"}};
  trial.sensor_noise = {0.001};
  trial.command_noise = {kNotKnown};
  return trial;
}

TEST(CanonicalText, EveryPartOfARevisionCounts) {
  const std::vector<std::function<void(RevisionRecord&)>> changes = {
      [](RevisionRecord&) {},
      [](RevisionRecord& r) { r.robot_text = "{}"; },
      [](RevisionRecord& r) { r.free[0].upper = 3.0; },
      [](RevisionRecord& r) { r.free[0].start = 0.6; },
      [](RevisionRecord& r) { r.free.clear(); },
      [](RevisionRecord& r) { r.effects[0].where = {"joint.other"}; },
      [](RevisionRecord& r) { r.effects[0].start["torque"] = 0.1; },
      [](RevisionRecord& r) { r.effects[0].fixed = {"torque"}; },
      [](RevisionRecord& r) { r.effects[0].id = "another"; },
      [](RevisionRecord& r) { r.engine.step = 0.0005; },
      [](RevisionRecord& r) { r.engine.substeps = 2; },
      [](RevisionRecord& r) { r.engine.control_period = 0.01; },
      [](RevisionRecord& r) { r.engine.joint_erp = 0.3; },
      [](RevisionRecord& r) { r.engine.delay_rounding = DelayRounding::step; },
      [](RevisionRecord& r) { r.engine.engine = "other"; },
      [](RevisionRecord& r) { r.fit_data_digest = test::kOtherDigest; }};
  std::set<std::string> digests;
  for (const auto& change : changes) {
    RevisionRecord revision = revision_with({friction("coulomb_friction")});
    change(revision);
    EXPECT_TRUE(digests.insert(digest_of(revision)).second) << "change " << digests.size() << " does not count";
  }
}

TEST(CanonicalText, NumbersReadBackToTheSameBits) {
  EffectList effects = {friction("a")};
  effects[0].start = {{"third", 1.0 / 3.0}, {"tiny", 5e-324}, {"limit", kInfinity}};
  EXPECT_EQ(effects_from_text(canonical_text(effects))[0].start, effects[0].start);
  EngineSettings engine;
  engine.step = 0.1 + 0.2;
  EXPECT_EQ(engine_from_text(canonical_text(engine)).step, engine.step);
}

TEST(CanonicalText, RobotsWithoutLimitsHaveAText) {
  RobotSpec robot;
  robot.joints.emplace_back().name = "hinge";
  RobotSpec limited = robot;
  limited.joints[0].upper = 1.0;
  EXPECT_NE(canonical_text(robot), canonical_text(limited));
}

TEST(CanonicalText, LawsOfAContactCountWhereItHasThem) {
  const RobotSpec plain;
  EXPECT_EQ(canonical_text(plain).find("restitution"), std::string::npos);
  std::set<std::string> texts = {canonical_text(plain)};
  for (double ContactSpec::*law :
       {&ContactSpec::impact_damping, &ContactSpec::restitution, &ContactSpec::rolling_lever, &ContactSpec::creep}) {
    RobotSpec robot;
    robot.contact.*law = 0.5;
    EXPECT_TRUE(texts.insert(canonical_text(robot)).second);
  }
}

TEST(TrialDigest, EverythingThatAFitSeesCounts) {
  const std::vector<std::function<void(Trial&)>> changes = {[](Trial&) {},
                                                            [](Trial& t) { t.measured.samples(5, 0) += 1e-12; },
                                                            [](Trial& t) { t.measured.samples(5, 0) = kNotKnown; },
                                                            [](Trial& t) { t.measured.times[9] += 1e-9; },
                                                            [](Trial& t) { t.measured.channels[0].name = "other"; },
                                                            [](Trial& t) { t.commands.series.samples(2, 0) = 0.0; },
                                                            [](Trial& t) { t.commands.hold = Hold::first_order; },
                                                            [](Trial& t) { t.commands.before = {0.1}; },
                                                            [](Trial& t) {
                                                              t.initial = {{InitialKnowledge::given, 0.1, 0.0}};
                                                            },
                                                            [](Trial& t) {
                                                              t.initial = {{InitialKnowledge::free, 0.1, 0.0}};
                                                            },
                                                            [](Trial& t) { t.sensor_noise = {0.002}; },
                                                            [](Trial& t) { t.command_noise = {0.002}; }};
  std::set<std::string> digests;
  for (const auto& change : changes) {
    Trial trial = some_trial();
    change(trial);
    EXPECT_TRUE(digests.insert(digest_of(trial)).second) << "change " << digests.size() << " does not count";
  }
}

TEST(TrialDigest, NamesDoNotCountAndHeldOutTrialsAreNotFitData) {
  Trial renamed = some_trial();
  renamed.name = "another";
  EXPECT_EQ(digest_of(renamed), digest_of(some_trial()));
  Trial held_out = some_trial();
  held_out.held_out = true;
  EXPECT_EQ(digest_of_trials(std::vector<Trial>{some_trial(), held_out}),
            digest_of_trials(std::vector<Trial>{some_trial()}));
  EXPECT_NE(digest_of_trials(std::vector<Trial>{some_trial(), some_trial()}),
            digest_of_trials(std::vector<Trial>{some_trial()}));
}

}  // namespace
}  // namespace lacuna
