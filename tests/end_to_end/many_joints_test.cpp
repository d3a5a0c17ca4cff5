#include "end_to_end/program.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <map>
#include <string>

namespace lacuna {
namespace {

constexpr std::array kDampings = {0.2, 0.05, 0.1, 0.02};  ///< N·m·s/rad, by joint

/// Arms side by side, each on a hinge with a motor: more joints than a set of the search has members.
std::string robot() {
  std::string text = "[robot]\nname = \"arms\"\n";
  for (std::size_t i = 0; i < kDampings.size(); ++i)
    text += fmt::format(
        "[body.arm{0}]\nat = [0.0, {0}.0, 0.0]\nmass = 1.0\ncom = [0.0, 0.0, -0.2]\ninertia = [0.01, 0.01, 0.01]\n"
        "[joint.hinge{0}]\nkind = \"hinge\"\nparent = \"world\"\nchild = \"arm{0}\"\naxis = \"y\"\n"
        "[actuator.motor{0}]\nkind = \"force\"\njoint = \"hinge{0}\"\n"
        "[sensor.angle{0}]\nkind = \"joint_position\"\njoint = \"hinge{0}\"\n",
        i);
  return text;
}

std::string experiment() {
  std::string effects;
  for (std::size_t i = 0; i < kDampings.size(); ++i)
    effects += fmt::format(
        " {{ id = \"grease{0}\", effect = \"viscous_friction\", where = \"joint.hinge{0}\", start = {{ damping = {1} "
        "}} "
        "}},\n",
        i, kDampings[i]);
  return fmt::format(R"([experiment]
name = "arms"
seed = 1
[target]
kind = "simulated"
file = "arms.toml"
noise = {{ "sensor.*" = "1 mrad" }}
effects = [
{}]
[model]
file = "arms.toml"
effects = []
[model.free]
"body.arm0.mass" = [0.5, 2.0]
[engine]
step = "10 ms"
)",
                     effects);
}

/// An arm has friction in all of its joints, in each as much as it has there.
TEST(ManyJoints, HaveAValueEach) {
  Program program;
  program.write("arms.toml", robot());
  program.write("rig.toml", experiment());
  std::string test;
  for (std::size_t i = 0; i < kDampings.size(); ++i)
    test += fmt::format("{}multisine motor{} 1 N*m 0.2-2 Hz 6 s seed {}", i == 0 ? "" : ", ", i, i + 1);
  const Outcome trial = program.run({"trial", "rig.toml", "--test", test});
  ASSERT_EQ(trial.exit_code, 0) << trial.errors;
  const Outcome outcome =
      program.run({"diagnose", "rig.toml", "--among", "viscous_friction", "coulomb_friction", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const nlohmann::json diagnosis = nlohmann::json::parse(outcome.output);
  ASSERT_EQ(diagnosis["verdict"], "effect_found");
  std::map<std::string, double> dampings;
  for (const nlohmann::json& effect : diagnosis["ranking"][0]["effects"]) {
    EXPECT_EQ(effect["effect"], "viscous_friction");
    dampings[effect["where"]] = effect["parameters"]["damping"]["value"];
  }
  ASSERT_EQ(dampings.size(), kDampings.size()) << outcome.output;
  for (std::size_t i = 0; i < kDampings.size(); ++i)
    EXPECT_NEAR(dampings.at(fmt::format("joint.hinge{}", i)), kDampings[i], 0.02 * kDampings[i]);
  ASSERT_EQ(program.run({"add", "rig.toml", "--answer"}).exit_code, 0);
  const Outcome compare = program.run({"compare", "rig.toml"});
  EXPECT_THAT(compare.output, testing::HasSubstr("the noise floor: as small as the noise allows")) << compare.errors;
}

}  // namespace
}  // namespace lacuna
