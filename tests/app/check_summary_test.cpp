#include "app/workspace/check_summary.h"

#include "config/robots/robot_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

Trial trial(const std::string& name, bool held_out) {
  Trial trial;
  trial.name = name;
  trial.held_out = held_out;
  trial.measured.times = Eigen::VectorXd::LinSpaced(5, 0.0, 2.0);
  trial.measured.channels = {{"angle", "rad"}};
  trial.measured.samples = TimeSeries::Samples::Zero(5, 1);
  trial.measured.samples.col(0) << -0.5, std::nan(""), 0.25, 1.5, 0.0;
  trial.commands.series = {{{"servo", "N*m"}}, trial.measured.times, TimeSeries::Samples::Constant(5, 1, 0.02)};
  return trial;
}

TEST(CheckSummary, SaysWhatAnExperimentHas) {
  Experiment experiment;
  experiment.model.declared.emplace();
  experiment.model.file = "robots/pendulum.toml";
  ModelDefinition definition;
  definition.structure.robot = read_robot(LACUNA_SOURCE_DIRECTORY "/tests/config/good/pendulum.toml");
  definition.free = {{{"body.arm.mass", "kg", 0.1, 2.0, 0.55, Scale::linear}, ""}};
  definition.effects = {{"friction", "coulomb_friction", {"joint.hinge"}, {}, {}}, {"drag", "drag", {}, {}, {}}};
  RecordingSource& source = experiment.target.recording;
  source.sensors.resize(1);
  source.sensors[0].channel = "angle";
  source.sensors[0].column = "angle_deg";
  source.sensors[0].unit = "deg";
  source.commands.resize(1);
  source.commands[0].channel = "servo";
  source.commands[0].column = "i_A";
  source.commands[0].unit = "A";
  source.commands[0].gain = 0.05;
  source.commands[0].gain_unit = "mN*m/A";
  const std::vector<Trial> trials = {trial("sine.csv", false), trial("chirp.csv", true)};
  std::vector<ReadingNote> notes(1);
  notes[0].location.file = "sine.csv";
  notes[0].location.line = 3;
  notes[0].message = "a gap";
  EXPECT_EQ(check_summary(experiment, definition, trials, notes),
            "robot     pendulum (pendulum.toml), 1 body\n"
            "joints    hinge\n"
            "actuators servo\n"
            "sensors   angle\n"
            "free      body.arm.mass: start 0.550 kg, bounds 0.100 kg to 2.00 kg\n"
            "effects   friction: coulomb_friction @ joint.hinge\n"
            "          drag: drag @ world\n"
            "trials    sine.csv: 5 samples, 2.00 s, 2 Hz\n"
            "          chirp.csv (held out): 5 samples, 2.00 s, 2 Hz\n"
            "          total 10 samples, 4.00 s\n"
            "channels  angle, measured: column angle_deg in deg, -0.500 rad to 1.50 rad, 2 values not compared\n"
            "          servo, commanded: column i_A in A × 50 mN·m/A, 20.0 mN·m to 20.0 mN·m\n"
            "driven    servo: a servo on the recorded goal, closed loop\n"
            "note      sine.csv:3: a gap\n");
}

TEST(CheckSummary, TellsTheRateOfASensorThatIsReadLessOften) {
  Trial joined = trial("drive.csv", false);
  joined.measured.samples.col(0) << 0.0, std::nan(""), std::nan(""), std::nan(""), 1.0;
  EXPECT_THAT(check_summary({}, {}, {joined}, {}), testing::HasSubstr("drive.csv: 5 samples, 2.00 s, angle 0.5 Hz\n"));
}

TEST(CheckSummary, SaysWhatAnExperimentHasNot) {
  ModelDefinition definition;
  definition.structure.robot.name = "ball";
  definition.structure.robot.bodies.resize(2);
  Experiment experiment;
  experiment.model.robot = "quadruped";
  EXPECT_EQ(check_summary(experiment, definition, {}, {}),
            "robot     ball (plugin quadruped), 2 bodies\n"
            "joints    none\nactuators none\nsensors   none\nfree      none\neffects   none\ntrials    none\n");
}

}  // namespace
}  // namespace lacuna
