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
  EXPECT_THAT(first.errors, HasSubstr("run the same command again to go on"));
  const Outcome second = parts.run(kDiagnose);
  EXPECT_EQ(second.exit_code, 0);
  EXPECT_THAT(second.errors, HasSubstr("going on after 1 model"));
  EXPECT_EQ(found(parts), found(whole));
  EXPECT_THAT(unfinished(parts), HasSubstr("\n0"));
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

}  // namespace
}  // namespace lacuna
