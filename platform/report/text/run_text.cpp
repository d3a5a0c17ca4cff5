#include "report/text/run_text.h"

#include "foundation/unit.h"
#include "report/text/text_table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

using Json = nlohmann::ordered_json;

std::string run_figure(double value, int digits = 4) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "-";
}

/// Figures over several parameters, or of all effects; those of single parameters would fill the page.
bool is_group(const ObjectiveRow& row) { return row.name.find('*') != std::string::npos || row.name == "effects"; }

/// What the test of this pass did on the target. A later trial than those that the pass knew without it: the target
/// could not carry it out, and another test took its place.
std::string on_target(const PassRow& pass, const std::vector<TargetTrialRow>& trials) {
  if (!pass.best_test) return "-";
  bool passed_over = false;
  for (const TargetTrialRow& trial : trials) {
    if (trial.test == pass.best_test) return run_figure(trial.measured_fitness);
    passed_over = passed_over || trial.number >= pass.number;
  }
  return passed_over ? "replaced" : "-";
}

Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// Of all passes, each once: models that do without effects have no figures of these.
std::vector<std::string> group_names(const std::vector<PassRow>& passes) {
  std::vector<std::string> names;
  for (const PassRow& pass : passes)
    for (const ObjectiveRow& row : pass.objective)
      if (is_group(row) && std::find(names.begin(), names.end(), row.name) == names.end()) names.push_back(row.name);
  return names;
}

std::string group_figure(const PassRow& pass, const std::string& name) {
  for (const ObjectiveRow& row : pass.objective)
    if (row.name == name) return row.unit == "1" ? run_figure(row.value, 3) : format_quantity(row.value, row.unit);
  return "-";
}

std::vector<std::string> head(const std::vector<std::string>& groups) {
  std::vector<std::string> cells = {"pass", "error"};
  for (const std::string& group : groups) cells.push_back(group + " off by");
  for (const char* name : {"test predicted", "on target", "models", "abandoned", "reused", "invalid", "steps"})
    cells.emplace_back(name);
  return cells;
}

}  // namespace

std::string passes_text(const std::vector<PassRow>& passes, const std::vector<TargetTrialRow>& trials) {
  if (passes.empty()) return "no finished pass\n";
  const std::vector<std::string> groups = group_names(passes);
  std::vector<std::vector<std::string>> table = {head(groups)};
  for (const PassRow& pass : passes) {
    std::vector<std::string> cells = {std::to_string(pass.number), run_figure(pass.best_score)};
    for (const std::string& group : groups) cells.push_back(group_figure(pass, group));
    cells.push_back(run_figure(pass.best_fitness));
    cells.push_back(on_target(pass, trials));
    for (const std::uint64_t count : {pass.evaluations, pass.abandoned, pass.reused, pass.invalid, pass.steps})
      cells.push_back(std::to_string(count));
    table.push_back(std::move(cells));
  }
  return text_table(table);
}

std::string runs_text(const std::vector<EeaRunListing>& runs) {
  if (runs.empty()) return "no run yet; make one: lacuna run FILE\n";
  std::vector<std::vector<std::string>> table = {
      {"run", "experiment", "replicate", "ended", "passes", "error", "models", "evaluations"}};
  for (const EeaRunListing& run : runs)
    table.push_back({std::to_string(run.run.value), run.experiment, std::to_string(run.replicate),
                     run.stopped.empty() ? run.ending : run.ending + ", stopped early",
                     fmt::format("{}/{}", run.passes_done, run.passes), run_figure(run.best_score.value_or(kNotKnown)),
                     std::to_string(run.models), std::to_string(run.evaluations)});
  return text_table(table, 2);
}

Json pass_json(const PassRow& pass) {
  Json objective = Json::object();
  for (const ObjectiveRow& row : pass.objective)
    objective[row.name] = {{"value", json_number(row.value)}, {"unit", row.unit}};
  return {{"pass", pass.number},
          {"error", json_number(pass.best_score)},
          {"objective", objective},
          {"predicted_fitness", json_number(pass.best_fitness)},
          {"evaluations", pass.evaluations},
          {"abandoned", pass.abandoned},
          {"reused", pass.reused},
          {"invalid", pass.invalid},
          {"steps", pass.steps},
          {"test_evaluations", pass.test_evaluations},
          {"invalid_tests", pass.invalid_tests},
          {"test_steps", pass.test_steps},
          {"stopped", pass.stopped}};
}

Json runs_json(const std::vector<EeaRunListing>& runs) {
  Json json = Json::array();
  for (const EeaRunListing& run : runs)
    json.push_back({{"run", run.run.value},
                    {"experiment", run.experiment},
                    {"replicate", run.replicate},
                    {"ending", run.ending},
                    {"stopped", run.stopped},
                    {"passes_done", run.passes_done},
                    {"passes", run.passes},
                    {"error", run.best_score ? Json(*run.best_score) : Json(nullptr)},
                    {"models", run.models},
                    {"evaluations", run.evaluations}});
  return json;
}

}  // namespace lacuna
