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
    const Outcome outcome = program_.shell("lacuna " + command + " --json --quiet");
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

  const Program program_;
};

constexpr double kFarFromTheFloor = 4.0;
constexpr double kAtTheFloor = 1.3;

TEST_F(OutsideLoop, FindsTheFrictionOfThePendulumInPython) {
  ASSERT_EQ(program_.shell("lacuna run outside-pendulum.toml --quiet").exit_code, 0);
  ASSERT_EQ(program_.shell("lacuna compare outside-pendulum.toml --quiet").exit_code, 0);
  EXPECT_GT(times_floor("outside-pendulum.toml", 1, "angle"), kFarFromTheFloor);
  const json diagnosis = told("diagnose outside-pendulum.toml");
  EXPECT_EQ(diagnosis["verdict"], "effect_found") << diagnosis.dump(1);
  ASSERT_EQ(program_.shell("lacuna add outside-pendulum.toml coulomb_friction --where joint.hinge --quiet").exit_code,
            0);
  ASSERT_EQ(program_.shell("lacuna compare outside-pendulum.toml --quiet").exit_code, 0);
  EXPECT_LT(times_floor("outside-pendulum.toml", 2, "angle"), kAtTheFloor);
}

TEST_F(OutsideLoop, FindsTheFrictionOfTheCartPoleOnMuJoCo) {
  if (!std::filesystem::exists(LACUNA_BINARY_DIRECTORY "/bin/mujoco_cart_pole"))
    GTEST_SKIP() << "MuJoCo, which this target is computed with, is not installed";
  ASSERT_EQ(program_.shell("lacuna run outside-cart-pole.toml --quiet").exit_code, 0);
  ASSERT_EQ(program_.shell("lacuna compare outside-cart-pole.toml --quiet").exit_code, 0);
  EXPECT_GT(times_floor("outside-cart-pole.toml", 1, "position"), kFarFromTheFloor);
  const json diagnosis = told("diagnose outside-cart-pole.toml");
  EXPECT_EQ(diagnosis["verdict"], "effect_found") << diagnosis.dump(1);
}

bool has_mujoco() { return std::filesystem::exists(LACUNA_BINARY_DIRECTORY "/bin/mujoco_cart_pole"); }

/// All but the part that needs MuJoCo is followed without it, too.
TEST(AttachARig, PrintsWhatItSays) {
  const Program program;
  program.copy_outside_targets();
  follow_guide("docs/tutorials/attach-a-rig.md", program, has_mujoco() ? "" : "## Another engine");
}

}  // namespace
}  // namespace lacuna
