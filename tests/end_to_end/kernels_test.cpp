#include "end_to_end/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lacuna {
namespace {

using testing::HasSubstr;

/// Diagnoses the servo pendulum with two effects to choose from, after `environment`.
nlohmann::json found_with(const std::string& environment) {
  const Program program;
  program.copy_first_steps();
  const Outcome outcome = program.shell(environment +
                                        " lacuna diagnose first-steps.toml --json=found.json"
                                        " --among coulomb_friction joint_spring");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  return nlohmann::json::parse(program.read("found.json"));
}

TEST(Kernels, OfEveryLevelLeadToTheSameVerdict) {
  const nlohmann::json fastest = found_with(""), portable = found_with("LACUNA_KERNELS=portable");
  EXPECT_EQ(fastest["verdict"], "effect_found");
  EXPECT_EQ(portable["verdict"], fastest["verdict"]);
  const auto effect = [](const nlohmann::json& diagnosis) { return diagnosis["ranking"][0]["effects"][0]["effect"]; };
  EXPECT_EQ(effect(fastest), "coulomb_friction");
  EXPECT_EQ(effect(portable), "coulomb_friction");
}

TEST(Kernels, ThatAreUnknownAreBadInputAndTheKnownOnesAreNamed) {
  const Program program;
  const Outcome outcome = program.shell("LACUNA_KERNELS=fast lacuna plugins list");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("environment variable LACUNA_KERNELS: no kernels \"fast\""));
  EXPECT_THAT(outcome.errors, HasSubstr("set it to portable"));
  EXPECT_EQ(outcome.output, "");
}

}  // namespace
}  // namespace lacuna
