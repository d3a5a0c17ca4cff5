#include "commands/commands.h"
#include "commands/sets_text.h"

#include "contacts/contact_plan.h"
#include "dirty/dirty_rig.h"
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

using PlanRows = std::vector<std::vector<std::string>>;

PlanRows plan_rows(const std::string& set) {
  PlanRows rows = {kHead};
  for (const CasePlan& plan : plan_all_cases(set))
    rows.push_back({std::to_string(plan.number), plan.group, plan.rig, hidden_text(plan),
                    fmt::format("{:g}", plan.strength), std::string(to_string(plan.noise)), std::to_string(plan.seed)});
  return rows;
}

/// What is drawn before anything is simulated; the laws are chosen by what they do.
PlanRows dirty_plan_rows(const std::string& set) {
  PlanRows rows = {{"number", "family", "mass [kg]", "rate [Hz]", "samples", "duration [s]", "files", "free", "main",
                    "strength", "small", "misstated", "seed"}};
  for (const dirty::DirtyPlan& plan : dirty::plan_dirty_cases(set)) {
    const dirty::DirtyRig rig = dirty::draw_rig(plan);
    const dirty::TrialPlan& first = rig.trials.front();
    rows.push_back({std::to_string(plan.number), plan.family, fmt::format("{:.3g}", dirty::mass_of(rig)),
                    fmt::format("{:.4g}", 1.0 / rig.interval), std::to_string(first.samples),
                    fmt::format("{:.3g}", rig.interval * static_cast<double>(first.samples)),
                    std::to_string(rig.trials.size()), std::to_string(rig.free.size()),
                    plan.gross ? "a wrong value" : std::to_string(plan.mains),
                    plan.mains == 0 ? "" : fmt::format("{:.3g}", plan.strength), std::to_string(plan.small),
                    std::to_string(plan.misstated), std::to_string(plan.seed)});
  }
  return rows;
}

void print_plan(const PlanOptions& options) {
  const PlanRows rows = dirty::is_dirty_set(options.set) ? dirty_plan_rows(options.set) : plan_rows(options.set);
  if (!options.csv) return fmt::print("{}", lacuna::text_table(rows, rows.front().size()));
  for (const std::vector<std::string>& row : rows) fmt::print("{}\n", fmt::join(row, ","));
}

}  // namespace

void add_plan_command(CLI::App& program) {
  auto options = std::make_shared<PlanOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("plan", "List the cases of a set");
  command->add_option("--set", options->set, kSets)->required()->option_text("SET");
  command->add_flag("--csv", options->csv, "As CSV");
  command->callback([options] { print_plan(*options); });
}

}  // namespace hidden_effects
