#include "end_to_end/guide.h"
#include "end_to_end/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace lacuna {
namespace {

using nlohmann::json;

/// Explore, diagnose, add: the loop on a target outside.
class OutsideLoop : public testing::Test {
 protected:
  OutsideLoop() { program_.copy_outside_targets(); }

  json told(const std::string& command) const {
    const Outcome outcome = program_.shell("lacuna " + command + " --json");
    EXPECT_EQ(outcome.exit_code, 0) << command << "\n" << outcome.errors;
    return outcome.exit_code == 0 ? json::parse(outcome.output) : json();
  }
  /// The fit error of a revision over its floor.
  double times_floor(const std::string& experiment, int revision, const std::string& channel) const {
    const json history = told("history " + experiment);
    for (const json& row : history["revisions"])
      if (row["revision"] == revision && row["channel"] == channel)
        return row["fit_rmse"].get<double>() / row["floor"].get<double>();
    ADD_FAILURE() << "no revision " << revision << " of " << channel;
    return 0.0;
  }

  void go_round(const std::string& experiment, const std::string& joint, const std::string& channel) const;

  const Program program_;
};

bool has_mujoco() { return std::filesystem::exists(LACUNA_BINARY_DIRECTORY "/bin/mujoco_cart_pole"); }

constexpr double kFarFromTheFloor = 10.0;
constexpr double kAtTheFloor = 1.3;

/// The friction of a joint is what the model lacks.
void OutsideLoop::go_round(const std::string& experiment, const std::string& joint, const std::string& channel) const {
  const auto lacuna = [&](const std::string& command) {
    return program_.shell("lacuna " + command + " --quiet").exit_code;
  };
  ASSERT_EQ(lacuna("run " + experiment), 0);
  ASSERT_EQ(lacuna("compare " + experiment), 0);
  EXPECT_GT(times_floor(experiment, 1, channel), kFarFromTheFloor);
  const Outcome diagnosis = program_.shell("lacuna diagnose " + experiment + " --quiet");
  EXPECT_THAT(diagnosis.output, testing::StartsWith("verdict effect_found"));
  EXPECT_THAT(diagnosis.output, testing::HasSubstr("1  coulomb_friction @ " + joint));
  ASSERT_EQ(lacuna("add " + experiment + " coulomb_friction --where " + joint), 0);
  ASSERT_EQ(lacuna("compare " + experiment), 0);
  EXPECT_LT(times_floor(experiment, 2, channel), kAtTheFloor);
}

TEST_F(OutsideLoop, FindsTheFrictionOfThePendulumInPython) {
  go_round("outside-pendulum.toml", "joint.hinge", "angle");
}

TEST_F(OutsideLoop, FindsTheFrictionOfTheCartPoleOnMuJoCo) {
  if (!has_mujoco()) GTEST_SKIP() << "MuJoCo, which this target is computed with, is not installed";
  go_round("outside-cart-pole.toml", "joint.rail", "position");
}

/// All but the part that needs MuJoCo is followed without it, too.
TEST(AttachARig, PrintsWhatItSays) {
  const Program program;
  program.copy_outside_targets();
  follow_guide("docs/tutorials/attach-a-rig.md", program, has_mujoco() ? "" : "## Another engine");
}

}  // namespace
}  // namespace lacuna
