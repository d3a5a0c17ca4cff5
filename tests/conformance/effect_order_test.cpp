#include "conformance/effect_rig.h"

#include "support/convergence.h"
#include "support/robots.h"
#include "support/test_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>

/// With which order each effect's motion converges as the step is halved: measured, and told in
/// docs/reference/effects.md.
namespace lacuna::effect_order_test {
namespace {

constexpr const char* kPage = LACUNA_SOURCE_DIRECTORY "/docs/reference/effects.md";
constexpr const char* kBegin = "<!-- orders: begin -->\n";
constexpr const char* kEnd = "<!-- orders: end -->\n";
constexpr const char* kHow =
    "LACUNA_WRITE_EFFECT_ORDERS=1 build/release/bin/whole_conformance_test --gtest_filter='EffectOrder.*'";
constexpr int kHalvings = 6;

/// What is to be known of an effect's order.
std::string remark_on(const std::string& effect, const SimulationRun& run) {
  static const std::map<std::string, std::string> remarks = {
      {"backlash",
       "measured with flanks damped by 2 N·m·s/rad: without damping they rattle faster than a step of 1 ms, "
       "which damps that instead of following it"},
      {"quantisation", "readings are whole counts, which a finer step does not change"}};
  if (engine_for(run.structure.robot) == "ode") return "contacts are ODE's";
  const auto found = remarks.find(effect);
  return found == remarks.end() ? "" : found->second;
}

/// The effect of a README at its start values.
PlacedEffect effect_of(const ModelDefinition& model) {
  PlacedEffect effect = model.structure.effects.front();
  const ParameterDeclarations declared = effect.effect->describe().parameters;
  for (std::size_t p = 0; p < model.structure.parameters.size(); ++p)
    for (std::size_t i = 0; i < declared.size(); ++i)
      if (model.structure.parameters[p].address == "effect." + effect.id + "." + declared[i].name)
        effect.values[i] = model.start_values()[p];
  return effect;
}

/// A ball that slides on soft ground: a rigid one is met at the end of a step, wherever that falls.
SimulationRun sliding_ball(const PlacedEffect& effect) {
  constexpr double kMass = 2.0, kRadius = 0.1, kInertia = 0.4 * kMass * kRadius * kRadius;
  RobotSpec robot = floating_body(kMass, {.xx = kInertia, .yy = kInertia, .zz = kInertia});
  robot.bodies[0].position = {0.0, 0.0, kRadius};
  robot.bodies[0].shapes = {{.kind = ShapeKind::sphere, .size = {kRadius, 0.0, 0.0}}};
  robot.gravity = {12.0, 0.0, -kGravity};
  robot.contact = {.ground = true, .stiffness = 2e4, .damping = 300.0, .friction = 0.5};
  SimulationRun run(robot, 1e-3);
  run.structure.effects = {effect};
  return run;
}

SimulationRun motion_of(const std::string& effect) {
  const ModelDefinition model = readme_model(effect);
  PlacedEffect placed = effect_of(model);
  if (engine_for(model.structure.robot) == "ode") return sliding_ball(placed);
  if (effect == "backlash") placed.values[2] = 2.0;  // N·m·s/rad, damping
  return moving_with(model, placed.values);
}

std::string order_of(SimulationRun run) {
  const auto solution = [&](int halving) {
    run.engine.substeps = 1 << halving;
    return readings(run);
  };
  const Convergence found = converge(solution, kHalvings);
  std::cout << run.structure.effects.front().name << ": " << to_string(found) << '\n';
  if (found.exact) return "exact";
  return fmt::format("{:.0f}", std::min(found.order, 2.0));  // more would be chance
}

std::string measured_table() {
  std::string table = "| effect | order | remark |\n| --- | --- | --- |\n";
  for (const std::string& effect : every_effect()) {
    const SimulationRun run = motion_of(effect);
    const std::string order = order_of(run), remark = remark_on(effect, run);
    EXPECT_TRUE(order == "exact" || order == "2" || !remark.empty())
        << effect << " is of order " << order << "; say why in remark_on";
    table += fmt::format("| {} | {} | {} |\n", effect, order, remark);
  }
  return table;
}

struct Page {
  std::string before, table, after;
};

Page read_page() {
  const std::string text = read_bytes(kPage);
  const std::size_t begin = text.find(kBegin), end = text.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos)
    throw Error(std::string(kPage) + " has lost the comments between which the table of orders stands");
  const std::size_t first = begin + std::string(kBegin).size();
  return {text.substr(0, first), text.substr(first, end - first), text.substr(end)};
}

TEST(EffectOrder, IsThatOfTheTableInTheReference) {
  if (std::getenv("LACUNA_EFFECTS_UNDER_TEST")) GTEST_SKIP() << "the table has Lacuna's own effects only";
  const std::string table = measured_table();
  std::cout << table;
  const Page page = read_page();
  if (std::getenv("LACUNA_WRITE_EFFECT_ORDERS"))
    std::ofstream(kPage) << page.before << table << page.after;
  else
    EXPECT_EQ(page.table, table) << "write it anew: " << kHow;
}

}  // namespace
}  // namespace lacuna::effect_order_test
