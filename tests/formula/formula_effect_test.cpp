#include "loading/plugin_catalog.h"
#include "support/robots.h"
#include "support/simulation_run.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

/// The plugins that were written from formulas and compiled: their force is the formula's.
namespace lacuna {
namespace {

constexpr double kRounding = 1e-12;

const PhysicalEffect& written(const std::string& name) {
  static const PluginCatalog catalog({FORMULA_PLUGINS});
  return catalog.get<PhysicalEffect>(name);
}

double sign(double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; }

/// The force on a moving joint at its default parameters, dry friction as it acts while it slides.
double force_of(const PhysicalEffect& effect, double q, double v, double u) {
  std::vector<double> values;
  for (const ParameterDeclaration& parameter : effect.describe().parameters) values.push_back(parameter.default_value);
  const std::array<int, 1> elements = {0}, coordinates = {0};
  const std::array<double, 1> positions = {q}, velocities = {v};
  StepView view;
  view.positions = positions;
  view.velocities = velocities;
  view.first_coordinate = coordinates;
  view.actuator_coordinate = coordinates;
  const EffectContext context{values, elements, effect.describe().placements.front(), 1e-3};
  std::vector<double> state(static_cast<std::size_t>(effect.state_size(context)));
  if (effect.hooks().command != CommandStage::none) {
    EXPECT_EQ(effect.command(u, 0, view, context, state), u);
  }
  std::array<JointLoad, 1> joints;
  ContactSpec contact;
  Eigen::Vector3d gravity(0.0, 0.0, 0.0);
  StepLoads loads{joints, {}, contact, gravity};
  effect.add_loads(view, context, state, loads);
  const JointLoad& load = joints[0];
  const double friction = v > 0.0 ? load.friction_lower : v < 0.0 ? load.friction_upper : 0.0;
  return load.force + friction;
}

template <class Formula>
void expect_force(const std::string& name, Formula&& formula) {
  const PhysicalEffect& effect = written(name);
  for (double q = -3.0; q <= 3.0; q += 0.37)
    for (double v = -20.0; v <= 20.0; v += 0.8)  // through v = 0
      for (const double u : {-1.5, 0.0, 0.4})
        ASSERT_NEAR(force_of(effect, q, v, u), formula(q, v, u), kRounding * (1.0 + v * v))
            << q << " " << v << " " << u;
}

TEST(FormulaEffect, QuadraticDragIsItsFormula) {
  expect_force("formula_drag", [](double, double v, double) { return -0.01 * v * std::abs(v); });
}

TEST(FormulaEffect, AMixtureIsItsFormula) {
  expect_force("formula_mixture",
               [](double q, double v, double) { return -0.02 * v - 0.1 * sign(v) * q * q + 0.05 * std::sin(3.0 * q); });
}

TEST(FormulaEffect, ALawOfTheCommandIsItsFormula) {
  expect_force("formula_command",
               [](double, double v, double u) { return 0.02 * u * std::abs(v) - 0.1 * sign(v) * std::abs(u); });
}

SimulationRun with(const std::string& effect, std::vector<double> values) {
  SimulationRun run(one_joint(JointKind::hinge, 1.0));
  return run.place(written(effect), ElementKind::joint, {0}, std::move(values));
}

TEST(FormulaEffect, QuadraticDragSlowsAWheelAsItsEquationOfMotionSays) {
  constexpr double kDrag = 0.5, kSpeed = 4.0, kEnd = 2.0;
  const double v = with("formula_drag", {-kDrag}).from({0.0}, {kSpeed}).last("velocity", kEnd);
  EXPECT_NEAR(v, kSpeed / (1.0 + kDrag * kSpeed * kEnd), 1e-6);
}

TEST(FormulaEffect, FrictionThatGrowsWithPositionSticksAndBreaksAway) {
  constexpr double kFriction = 0.3, kPosition = 2.0;  // N·m/rad², rad: 1.2 N·m hold it there
  SimulationRun run = with("formula_mixture", {0.0, -kFriction, 0.0}).from({kPosition}, {0.0});
  EXPECT_NEAR(run.command("motor", 1.19).last("position", 1.0), kPosition, 1e-6);
  EXPECT_GT(run.command("motor", 1.21).last("position", 1.0), kPosition + 1e-3);
}

}  // namespace
}  // namespace lacuna
