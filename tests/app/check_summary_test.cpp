#include "app/check_summary.h"

#include "config/robot_reader.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

Trial trial(const std::string& name, bool held_out) {
  Trial trial;
  trial.name = name;
  trial.held_out = held_out;
  trial.measured.times = Eigen::VectorXd::LinSpaced(5, 0.0, 2.0);
  return trial;
}

TEST(CheckSummary, SaysWhatAnExperimentHas) {
  Experiment experiment;
  experiment.model.robot = "declared";
  ModelDefinition definition;
  definition.structure.robot = read_robot(LACUNA_SOURCE_DIRECTORY "/tests/config/good/pendulum.toml");
  definition.free = {{"body.arm.mass", "kg", 0.1, 2.0, 0.55, Scale::linear, ""}};
  definition.effects = {{"friction", "coulomb_friction", {"joint.hinge"}, {}, {}}, {"drag", "drag", {}, {}, {}}};
  Recording recording;
  recording.trials = {trial("sine.csv", false), trial("chirp.csv", true)};
  recording.notes.resize(1);
  recording.notes[0].location.file = "sine.csv";
  recording.notes[0].location.line = 3;
  recording.notes[0].message = "a gap";
  EXPECT_EQ(check_summary(experiment, definition, recording),
            "robot     pendulum (declared), 1 body\n"
            "joints    hinge\n"
            "actuators servo\n"
            "sensors   angle\n"
            "free      body.arm.mass from 0.550 kg, 0.100 kg to 2.00 kg\n"
            "effects   friction: coulomb_friction @ joint.hinge\n"
            "          drag: drag @ world\n"
            "trials    sine.csv: 5 samples, 2.00 s\n"
            "          chirp.csv (held out): 5 samples, 2.00 s\n"
            "note      sine.csv:3: a gap\n");
}

TEST(CheckSummary, SaysWhatAnExperimentHasNot) {
  ModelDefinition definition;
  definition.structure.robot.name = "ball";
  definition.structure.robot.bodies.resize(2);
  Experiment experiment;
  experiment.model.robot = "quadruped";
  EXPECT_EQ(check_summary(experiment, definition, {}),
            "robot     ball (quadruped), 2 bodies\n"
            "joints    none\nactuators none\nsensors   none\nfree      none\neffects   none\ntrials    none\n");
}

}  // namespace
}  // namespace lacuna
