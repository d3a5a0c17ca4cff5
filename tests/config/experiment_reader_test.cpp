#include "config/experiment_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace lacuna {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr const char* kGood = LACUNA_SOURCE_DIRECTORY "/tests/config/good";

Experiment complete(const std::vector<std::string>& overrides = {}) {
  setenv("LACUNA_TEST_FOLDER", kGood, 1);
  return read_experiment(std::string(kGood) + "/complete.toml", overrides);
}

TEST(ReadExperiment, ReadsTheTarget) {
  const RecordingSource source = complete().target.recording;
  ASSERT_EQ(source.files.size(), 2U);
  EXPECT_EQ(source.files[0].path, std::string(kGood) + "/sine.csv");
  EXPECT_FALSE(source.files[0].held_out);
  EXPECT_EQ(source.files[1].path, std::string(kGood) + "/chirp.csv");
  EXPECT_TRUE(source.files[1].held_out);
  EXPECT_EQ(source.files[1].location.line, 10);
  EXPECT_EQ(source.delimiter, ',');
  EXPECT_EQ(source.trial_column, "run");
  EXPECT_EQ(source.holdout_trials, (std::vector<std::string>{"3", "4"}));
  EXPECT_EQ(source.hold, Hold::first_order);
  EXPECT_EQ(source.time_column, "t_ms");
  EXPECT_EQ(source.time_unit, "ms");
  EXPECT_DOUBLE_EQ(source.max_gap, 0.05);
  ASSERT_EQ(source.use.size(), 2U);
  EXPECT_DOUBLE_EQ(source.use[1].start, 12.0);
  EXPECT_DOUBLE_EQ(source.use[1].end, 60.0);
  ASSERT_EQ(source.mask.size(), 1U);
  EXPECT_DOUBLE_EQ(source.mask[0].end, 2.5);
}

TEST(ReadExperiment, ReadsWhatHoldsForOneRecording) {
  const RecordingSource source = read_experiment(std::string(kGood) + "/recordings.toml").target.recording;
  ASSERT_EQ(source.files.size(), 2U);
  const MeasuredFile& sine = source.files[0];
  EXPECT_EQ(sine.path, std::string(kGood) + "/sine.csv");
  EXPECT_FALSE(sine.held_out);
  EXPECT_EQ(sine.location.line, 9);
  ASSERT_EQ(sine.use.size(), 1U);
  EXPECT_DOUBLE_EQ(sine.use[0].start, 1.0);
  ASSERT_EQ(sine.mask.size(), 1U);
  ASSERT_EQ(sine.holdout.size(), 2U);
  EXPECT_DOUBLE_EQ(sine.holdout[1].end, 20.0);
  EXPECT_TRUE(source.files[1].held_out);
  EXPECT_TRUE(source.files[1].use.empty());
  EXPECT_EQ(source.files[1].setup, (lacuna::Setup{"chirp", {{"body.torso.mass", 0.8}}}));
  EXPECT_EQ(source.files[1].initial.at("motor").command, 0.3);
  EXPECT_TRUE(sine.setup.name.empty());
  EXPECT_DOUBLE_EQ(source.sensors[0].gain, 2.0 * M_PI / 4096);
  EXPECT_EQ(source.sensors[0].gain_unit, "rad");
}

TEST(ReadExperiment, ReadsFurtherFilesOfARecording) {
  const RecordingSource source = read_experiment(std::string(kGood) + "/recordings.toml").target.recording;
  ASSERT_EQ(source.files[1].with.size(), 2U);
  const FurtherFile &camera = source.files[1].with[0], &force = source.files[1].with[1];
  EXPECT_FALSE(camera.offset);
  EXPECT_EQ(camera.skew, 0.0);
  EXPECT_DOUBLE_EQ(camera.between.second, 0.5);
  EXPECT_EQ(force.offset, -0.2);
  EXPECT_FALSE(force.skew);
  EXPECT_EQ(force.columns, std::vector<std::string>{"load"});
  EXPECT_EQ(force.time_unit, "ms");
}

TEST(ReadExperiment, ReadsColumnsInTheOrderOfTheFile) {
  const RecordingSource source = complete().target.recording;
  ASSERT_EQ(source.commands.size(), 1U);
  EXPECT_EQ(source.commands[0].channel, "servo");
  EXPECT_DOUBLE_EQ(source.commands[0].gain, 0.5);
  EXPECT_EQ(source.commands[0].gain_unit, "rad/V");
  EXPECT_DOUBLE_EQ(source.commands[0].offset, kDegree);
  ASSERT_EQ(source.sensors.size(), 2U);
  EXPECT_EQ(source.sensors[0].channel, "angle");
  EXPECT_DOUBLE_EQ(source.sensors[0].gain, -1.0);
  EXPECT_EQ(source.sensors[0].gain_unit, "");
  EXPECT_DOUBLE_EQ(source.sensors[0].noise, 0.05 * kDegree);
  EXPECT_EQ(source.sensors[0].location.line, 31);
  EXPECT_EQ(source.sensors[1].channel, "a-second_one");
  EXPECT_TRUE(std::isnan(source.sensors[1].noise));
}

TEST(ReadExperiment, ReadsInitialValues) {
  const auto initial = complete().target.recording.initial;
  EXPECT_EQ(initial.at("hinge").joint.knowledge, InitialKnowledge::given);
  EXPECT_DOUBLE_EQ(initial.at("hinge").joint.position, 10.0 * kDegree);
  EXPECT_DOUBLE_EQ(initial.at("hinge").joint.velocity, 0.5);
  EXPECT_FALSE(initial.at("hinge").command);
  EXPECT_EQ(initial.at("slider").joint.knowledge, InitialKnowledge::free);
  EXPECT_DOUBLE_EQ(initial.at("servo").command.value(), -5.0 * kDegree);
  EXPECT_TRUE(initial.at("hinge").states_joint && !initial.at("servo").states_joint);
}

TEST(ReadExperiment, ReadsTheModel) {
  const ModelSection model = complete().model;
  EXPECT_EQ(model.robot, "declared");
  ASSERT_TRUE(model.declared);
  EXPECT_EQ(model.declared->name, "pendulum");
  EXPECT_DOUBLE_EQ(model.set.at("body.arm.mass"), 0.6);
  ASSERT_EQ(model.free.size(), 2U);
  EXPECT_EQ(model.free[0].pattern, "joint.*.damping");
  EXPECT_DOUBLE_EQ(model.free[0].upper, 2.0);
  EXPECT_FALSE(model.free[0].start);
  EXPECT_DOUBLE_EQ(model.free[1].lower, -0.5);
  EXPECT_DOUBLE_EQ(*model.free[1].start, -0.3);
}

TEST(ReadExperiment, ReadsEffects) {
  const EffectList effects = complete().model.effects;
  ASSERT_EQ(effects.size(), 2U);
  EXPECT_EQ(effects[0].id, "friction");
  EXPECT_EQ(effects[0].where, std::vector<std::string>{"joint.hinge"});
  EXPECT_DOUBLE_EQ(effects[0].start.at("torque"), 0.1);
  EXPECT_EQ(effects[0].fixed, std::vector<std::string>{"torque"});
  EXPECT_EQ(effects[0].range.at("torque"), std::pair(0.0, 1.0));
  EXPECT_EQ(effects[1].id, "joint_offset_torque");
  EXPECT_EQ(effects[1].where.size(), 2U);
}

TEST(ReadExperiment, EffectsOfAModelAloneMayBeOptional) {
  const auto with = [](const std::string& model, const std::string& target) {
    return read_experiment_text("[experiment]\nname = \"small\"\n[target]\nkind = \"simulated\"\nrobot = \"r\"\n" +
                                    target + "[model]\nrobot = \"r\"\n" + model,
                                "small.toml");
  };
  const std::string effects = "effects = [{ effect = \"a\", optional = true }, { effect = \"b\" }]\n";
  const EffectList read = with(effects, "").model.effects;
  EXPECT_TRUE(read[0].optional);
  EXPECT_FALSE(read[1].optional);
  EXPECT_THROW(with("", effects), BadInput);
}

TEST(ReadExperiment, ReadsEngineFitAndNoise) {
  const Experiment experiment = complete();
  EXPECT_DOUBLE_EQ(experiment.engine.step, 0.0005);
  EXPECT_EQ(experiment.engine.substeps, 4);
  EXPECT_EQ(experiment.engine.delay_rounding, DelayRounding::step);
  EXPECT_DOUBLE_EQ(experiment.model.set.at("contact.stiffness"), 2e4);
  EXPECT_TRUE(std::isinf(experiment.model.set.at("contact.friction")));
  EXPECT_EQ(experiment.fit.method, "free_run");
  ASSERT_EQ(experiment.fit.segments.size(), 2U);
  EXPECT_DOUBLE_EQ(experiment.fit.segments[1], 0.7);
  EXPECT_EQ(experiment.fit.horizon, "2.5");
  EXPECT_EQ(experiment.fit.starts, 8);
  EXPECT_DOUBLE_EQ(experiment.noise.process.at("joint.hinge"), 0.004);
  EXPECT_DOUBLE_EQ(experiment.noise.process_correlation_time, 0.02);
}

TEST(ReadExperiment, KnowsWhereKeysStand) {
  const Experiment experiment = complete();
  EXPECT_EQ(experiment.where("engine.substeps").line, 62);
  EXPECT_EQ(experiment.where("model.effects[1].where[1]").line, 56);
  EXPECT_EQ(experiment.where("model.free.body.arm.com.z").line, 53);
  EXPECT_EQ(experiment.where("model.effects[1].start.torque").line, 56);
  EXPECT_EQ(experiment.where("model.set.contact.damping").line, 69);
  EXPECT_EQ(experiment.where("nothing.like.it").line, 0);
}

TEST(ReadExperiment, ChecksUnitsThatOnlyTheModelCanJudge) {
  const Experiment experiment = complete();
  ProblemList problems;
  experiment.check_unit("model.set.body.arm.mass", "kg", problems);
  experiment.check_unit("model.free.joint.*.damping[1]", "N*m*s/rad", problems);
  EXPECT_TRUE(problems.empty());
  experiment.check_unit("model.set.body.arm.mass", "m", problems);
  ASSERT_EQ(problems.all().size(), 1U);
  EXPECT_EQ(problems.all()[0].location.line, 52);
}

TEST(ReadExperiment, PutsOverridesBesideTheFile) {
  const Experiment experiment =
      complete({"engine.step=0.002", "model.effects[1].start.torque=\"1 N*m\"", "model.free.\"body.*.mass\"=[1, 7]",
                "experiment.name=another", "target.time.max_gap=2 s"});
  EXPECT_DOUBLE_EQ(experiment.engine.step, 0.002);
  EXPECT_DOUBLE_EQ(experiment.model.effects[1].start.at("torque"), 1.0);
  ASSERT_EQ(experiment.model.free.size(), 3U);
  EXPECT_EQ(experiment.model.free[2].pattern, "body.*.mass");
  EXPECT_EQ(experiment.name, "another");
  EXPECT_DOUBLE_EQ(experiment.target.recording.max_gap, 2.0);
  EXPECT_EQ(experiment.where("engine.substeps").line, 62);
  EXPECT_EQ(experiment.where("engine.step").file, "--set engine.step=0.002");
}

}  // namespace
}  // namespace lacuna
