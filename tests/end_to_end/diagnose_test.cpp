#include "end_to_end/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <csignal>

namespace lacuna {
namespace {

using testing::HasSubstr;

const std::vector<std::string> kDiagnose = {"diagnose", "first-steps.toml", "--json=found.json",
                                            "--among",  "coulomb_friction", "joint_spring"};

nlohmann::json found(const Program& program) {
  nlohmann::json document = nlohmann::json::parse(program.read("found.json"));
  document.erase("seconds");
  return document;
}

std::string unfinished(const Program& program) {
  return program.run({"sql", "first-steps.db", "--csv", "SELECT count(*) FROM unfinished_diagnosis"}).output;
}

TEST(Diagnose, InterruptedGoesOnToTheSameAnswer) {
  const Program whole;
  whole.copy_first_steps();
  ASSERT_EQ(whole.run(kDiagnose).exit_code, 0);
  EXPECT_EQ(found(whole)["verdict"], "effect_found");
  EXPECT_THAT(unfinished(whole), HasSubstr("\n0"));

  const Program parts;
  parts.copy_first_steps();
  ASSERT_EQ(parts.run({"fit", "first-steps.toml"}).exit_code, 0);
  const Outcome first = parts.run_and_signal(
      kDiagnose, [&] { return unfinished(parts).find("\n1") != std::string::npos; }, SIGINT);
  ASSERT_EQ(first.exit_code, 75) << "it ended before it was interrupted";
  EXPECT_THAT(first.errors, HasSubstr("to continue, run the same command again"));
  const Outcome second = parts.run(kDiagnose);
  EXPECT_EQ(second.exit_code, 0);
  EXPECT_THAT(second.errors, HasSubstr("continuing: 1 model known from an earlier call"));
  EXPECT_EQ(found(parts), found(whole));
  EXPECT_THAT(unfinished(parts), HasSubstr("\n0"));
}

/// Where nothing declares the noise, both estimate it, and in one way.
TEST(Diagnose, HasTheNoiseFloorOfCompare) {
  const Program program;
  program.copy_first_steps();
  ASSERT_EQ(program
                .shell("sed -i -e '/^noise = /d' -e '/^quantum = /d' robots/servo-pendulum.toml && "
                       "sed -i '/^\\[noise\\]/,$d' first-steps.toml")
                .exit_code,
            0);
  const Outcome compared = program.run({"compare", "first-steps.toml", "--as-is", "--json=compared.json"});
  ASSERT_EQ(compared.exit_code, 0) << compared.errors;
  ASSERT_EQ(program.run(kDiagnose).exit_code, 0);
  const nlohmann::json pooled = nlohmann::json::parse(program.read("compared.json"))["pooled"][0];
  EXPECT_EQ(pooled["floor_origin"], "estimated by smoothing the readings");
  EXPECT_DOUBLE_EQ(pooled["floor"].get<double>(), found(program)["noise_floor"]["angle"].get<double>());
}

/// A servo's friction that grows with the load, its motor constant unknown, by recordings that an independent program
/// made (experiments/data/lifting_servo).
TEST(Diagnose, TwoKnownLoadsTellLoadFrictionFromTheMotorsConstant) {
  const Program program;
  program.copy_lifting_servo();
  const Outcome outcome = program.run({"diagnose", "lifting-servo.toml", "--json=found.json", "--among",
                                       "load_friction", "coulomb_friction", "viscous_friction", "torque_saturation"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const nlohmann::json document = found(program);
  EXPECT_EQ(document["verdict"], "effect_found");
  const nlohmann::json& best = document["ranking"][0];
  ASSERT_EQ(best["effects"].size(), 1U);
  EXPECT_EQ(best["effects"][0]["effect"], "load_friction");
  const auto covers = [](const nlohmann::json& value, double truth) {
    return value["ci95"][0] < truth && truth < value["ci95"][1];
  };
  EXPECT_TRUE(covers(best["effects"][0]["parameters"]["ratio"], 0.22)) << best;
  EXPECT_TRUE(covers(document["values"]["actuator.servo.motor.torque_constant"], 0.32)) << document["values"];
}

TEST(Diagnose, TellsErrorsByHorizon) {
  const Program program;
  program.copy_lifting_servo();
  const Outcome outcome = program.run({"diagnose", "lifting-servo.toml", "--json=found.json", "--among",
                                       "load_friction", "coulomb_friction", "viscous_friction"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const nlohmann::json document = found(program);
  EXPECT_EQ(document["verdict"], "effect_found");
  EXPECT_TRUE(document["probability"].is_null()) << "the method is not calibrated yet";
  ASSERT_EQ(document["ranking"][0]["effects"].size(), 1U);
  const nlohmann::json& effect = document["ranking"][0]["effects"][0];
  EXPECT_EQ(effect["effect"], "load_friction");
  EXPECT_NEAR(effect["parameters"]["ratio"]["value"].get<double>(), 0.22, 0.005);
  ASSERT_GE(document["horizons"].size(), 3U);
  const nlohmann::json& longest = document["horizons"].back();
  EXPECT_LT(longest["answer"].get<double>(), 0.5 * longest["base"].get<double>());
  EXPECT_THAT(outcome.output, HasSubstr("cross-validated error"));
}

TEST(Diagnose, AddTakesTheAnswer) {
  const Program program;
  program.copy_lifting_servo();
  const Outcome early = program.run({"add", "lifting-servo.toml", "--answer"});
  EXPECT_EQ(early.exit_code, 2);
  EXPECT_THAT(early.errors,
              HasSubstr("no diagnosis of this model has found an effect; run: lacuna diagnose lifting-servo.toml"));
  const Outcome found = program.run(
      {"diagnose", "lifting-servo.toml", "--among", "load_friction", "coulomb_friction", "viscous_friction"});
  ASSERT_EQ(found.exit_code, 0) << found.errors;
  const Outcome both = program.run({"add", "lifting-servo.toml", "coulomb_friction", "--answer"});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_THAT(both.errors, HasSubstr("leave out the effect, --where"));
  const Outcome added = program.run({"add", "lifting-servo.toml", "--answer"});
  ASSERT_EQ(added.exit_code, 0) << added.errors;
  EXPECT_THAT(added.output, HasSubstr("load_friction starts at the values that the diagnosis found"));
  EXPECT_THAT(program.read("lifting-servo.toml"), HasSubstr("effect = \"load_friction\""));
  EXPECT_EQ(program.run({"check", "lifting-servo.toml"}).exit_code, 0);
}

/// Records a pendulum of that mass, whose motor is not centred, with an encoder of 1 mrad.
void record_pendulum(const Program& program, const std::string& name, const std::string& mass) {
  program.write("sim.toml", R"([experiment]
name = "sim"
[target]
kind = "simulated"
file = "robots/servo-pendulum.toml"
set = { "actuator.motor.force_limit" = 0.5, "body.arm.mass" = )" +
                                mass + R"( }
effects = [{ effect = "joint_offset_torque", where = "joint.hinge", start = { torque = 0.001 } }]
noise = { "sensor.angle" = "1 mrad" }
[model]
file = "robots/servo-pendulum.toml"
free = { "joint.hinge.damping" = [0.0, 0.2] }
[engine]
step = "10 ms"
)");
  const Outcome trial = program.run({"trial", "sim.toml", "--test", "steps motor 0.05 N*m 1 Hz 2 s seed 3"});
  ASSERT_EQ(trial.exit_code, 0) << trial.errors;
  const Outcome samples = program.run(
      {"sql", "sim.db", "--csv",
       "SELECT m.time AS t_s, m.value AS angle_rad, c.value AS torque_Nm FROM trace_samples((SELECT max(id) FROM "
       "traces "
       "WHERE kind = 'measured')) AS m JOIN trace_samples((SELECT max(id) FROM traces WHERE kind = 'commands')) AS c "
       "ON c.sample = m.sample WHERE m.channel = 'angle' ORDER BY m.time"});
  program.write(name, samples.output);
}

/// An offset of the motor and a tilted mount look alike on short recordings of small swings, with two loads.
TEST(Diagnose, ProposesATestInASetupOfTheRecordings) {
  const Program program;
  program.copy_first_steps();
  record_pendulum(program, "light.csv", "0.3");
  record_pendulum(program, "heavy.csv", "0.34");
  program.write("loads.toml", R"([experiment]
name = "loads"
[target]
kind = "recorded"
[[target.recording]]
file = "light.csv"
set = { "body.arm.mass" = "0.3 kg" }
[[target.recording]]
file = "heavy.csv"
set = { "body.arm.mass" = "0.34 kg" }
[target.time]
column = "t_s"
[target.sensors]
angle = { column = "angle_rad", unit = "rad", noise = "1 mrad" }
[target.commands]
motor = { column = "torque_Nm", unit = "N*m" }
[model]
file = "robots/servo-pendulum.toml"
set = { "actuator.motor.force_limit" = 0.5 }
free = { "joint.hinge.damping" = [0.0, 0.2] }
[engine]
step = "10 ms"
)");
  const Outcome outcome =
      program.run({"diagnose", "loads.toml", "--json=found.json", "--among", "joint_offset_torque", "sensor_offset"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const nlohmann::json document = found(program);
  ASSERT_NE(document["next_test"], "") << outcome.output;
  const std::string setup = document["next_test_setup"]["name"];
  EXPECT_THAT(setup, testing::AnyOf("light", "heavy"));
  const Outcome again = program.run({"diagnose", "loads.toml", "--among", "joint_offset_torque", "sensor_offset"});
  EXPECT_THAT(again.output, HasSubstr("with setup " + setup + " (body.arm.mass = 0."));
  const std::string command = "lacuna trial loads.toml --test '" + document["next_test"].get<std::string>() +
                              "' --setup " + setup + " --csv=next.csv";
  EXPECT_THAT(again.output, HasSubstr("→ " + command + "\n"));
  EXPECT_EQ(program.shell(command).exit_code, 0) << "it can be typed as it is printed";
  const Outcome stored = program.run({"sql", "loads.db", "--csv", "SELECT next_test_setup FROM diagnoses"});
  EXPECT_EQ(stored.output, "next_test_setup\n" + setup + "\n");
}

}  // namespace
}  // namespace lacuna
