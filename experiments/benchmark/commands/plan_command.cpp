#include "commands/commands.h"

#include "contacts/contact_plan.h"
#include "report/text/text_table.h"
#include "runs/case_truth.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

namespace hidden_effects {
namespace {

struct PlanOptions {
  std::string set;
  bool csv = false;
};

const std::vector<std::string> kHead = {"number", "group", "rig", "hidden", "strength", "noise", "seed"};

/// "coulomb_friction @ joint.hinge + ..."
std::string hidden_text(const CasePlan& plan) {
  std::vector<std::string> laws;
  for (const HiddenLawRecord& law : about_plan(plan, "").hidden)
    laws.push_back(fmt::format("{} @ {}", law.law, law.answer.place));
  return fmt::format("{}", fmt::join(laws, " + "));
}

void print_plan(const PlanOptions& options) {
  std::vector<std::vector<std::string>> rows = {kHead};
  for (const CasePlan& plan : plan_all_cases(options.set))
    rows.push_back({std::to_string(plan.number), plan.group, plan.rig, hidden_text(plan),
                    fmt::format("{:g}", plan.strength), std::string(to_string(plan.noise)), std::to_string(plan.seed)});
  if (!options.csv) return fmt::print("{}", lacuna::text_table(rows, kHead.size()));
  for (const std::vector<std::string>& row : rows) fmt::print("{}\n", fmt::join(row, ","));
}

}  // namespace

void add_plan_command(CLI::App& program) {
  auto options = std::make_shared<PlanOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("plan", "List the cases of a set");
  command->add_option("--set", options->set, "tuning, reporting or fixed")->required()->option_text("SET");
  command->add_flag("--csv", options->csv, "As CSV");
  command->callback([options] { print_plan(*options); });
}

}  // namespace hidden_effects
