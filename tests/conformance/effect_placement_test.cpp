#include "conformance/effect_rig.h"

#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/tolerances.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

#include <array>

/// Where an effect stands: on several elements it is what it is on each, and it refuses joints that have nothing for
/// it.
namespace lacuna {
namespace {

/// Two driven links, and the elements of each kind that an effect is placed on.
RobotSpec two_links() {
  RobotSpec robot = double_pendulum(0.6, 0.3, 0.01);
  for (const char* joint : {"upper", "lower"}) {
    ActuatorSpec& motor = robot.actuators.emplace_back();
    motor.name = joint;
    motor.joint = joint;
    motor.transmission.rotor_inertia = 0.002;
  }
  return robot;
}

std::array<int, 2> two_of(ElementKind kind) {
  return kind == ElementKind::sensor ? std::array<int, 2>{0, 2} : std::array<int, 2>{0, 1};  // sensors: both angles
}

SimulationRun driven() {
  SimulationRun run(two_links());
  CommandSeries commands{.series = {}, .hold = Hold::zero_order};
  commands.series.channels = {{"upper", "N*m"}, {"lower", "N*m"}};
  commands.series.times = Eigen::Vector4d(0.0, 0.1, 0.25, 0.4);
  commands.series.samples.resize(4, 2);
  commands.series.samples << 1.5, -0.4, -1.0, 0.7, 0.3, 0.2, 0.9, -0.6;
  run.test.drive = commands;
  return run.from({0.5, -0.3}, {0.0, 0.0});
}

TEST(EffectConformance, OnSeveralElementsItIsWhatItIsOnEach) {
  on_every_effect([](const std::string& name, const PhysicalEffect& effect) {
    const PlacedEffect placed = readme_model(name).structure.effects.front();
    if (placed.kind == ElementKind::world || placed.elements.size() > 1) return;  // the latter acts between elements
    const auto [first, second] = two_of(placed.kind);
    SimulationRun together = driven(), apart = driven();
    together.place(effect, placed.kind, {first, second}, placed.values);
    apart.place(effect, placed.kind, {first}, placed.values).place(effect, placed.kind, {second}, placed.values);
    EXPECT_LE((readings(together) - readings(apart)).cwiseAbs().maxCoeff(), kRounding);
  });
}

TEST(EffectConformance, RefusesJointsThatHaveNothingForIt) {
  on_every_effect([](const std::string&, const PhysicalEffect& effect) {
    const EffectDescription description = effect.describe();
    if (description.placements != std::vector<ElementKind>{ElementKind::joint}) return;
    std::vector<double> values;
    for (const ParameterDeclaration& parameter : description.parameters) values.push_back(parameter.default_value);
    RobotSpec robot = one_joint(JointKind::hinge, 1.0);
    const std::vector<int> elements = {0};
    for (const JointKind kind : {JointKind::fixed, JointKind::ball}) {
      robot.joints[0].kind = kind;
      EXPECT_THAT(([&] {
                    effect.amend(robot, {values, elements, ElementKind::joint, 1e-3});
                  }),
                  testing::ThrowsMessage<Error>(testing::HasSubstr("joint.joint is a ")));
    }
  });
}

}  // namespace
}  // namespace lacuna
