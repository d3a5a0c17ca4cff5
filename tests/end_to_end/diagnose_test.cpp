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

}  // namespace
}  // namespace lacuna
