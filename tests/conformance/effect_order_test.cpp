#include "conformance/effect_rig.h"

#include "support/convergence.h"
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
std::string note_on(const std::string& effect, const SimulationRun& run) {
  static const std::map<std::string, std::string> notes = {
      {"backlash",
       "measured with flanks damped by 2 N·m·s/rad: without damping they rattle faster than a step of 1 ms, "
       "which damps that instead of following it"},
      {"quantisation", "readings are whole counts, which a finer step does not change"}};
  if (engine_for(run.structure.robot) == "ode") return "contacts are ODE's; not measured";
  const auto found = notes.find(effect);
  return found == notes.end() ? "" : found->second;
}

SimulationRun motion_of(const std::string& effect) {
  const ModelDefinition model = readme_model(effect);
  SimulationRun run = moving(model);
  if (effect == "backlash") {
    std::vector<double> values = model.structure.effects.front().values;
    values[0] = model.start_values().at(0);
    values[2] = 2.0;
    run = moving_with(model, values);
  }
  return run;
}

std::string order_of(SimulationRun run) {
  if (engine_for(run.structure.robot) == "ode") return "1";
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
    const std::string order = order_of(run), note = note_on(effect, run);
    EXPECT_TRUE(order == "exact" || order == "2" || !note.empty())
        << effect << " is of order " << order << "; say why in note_on";
    table += fmt::format("| {} | {} | {} |\n", effect, order, note);
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
