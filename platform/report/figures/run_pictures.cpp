#include "report/figures/run_pictures.h"

#include "foundation/text/unit_text.h"
#include "report/figures/spread.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace lacuna {
namespace {

/// A figure by pass over all runs: a line through the means, and a band of their 95 % intervals where there are
/// several.
void add_by_pass(std::vector<Series>& series, const std::map<int, std::vector<double>>& by_pass,
                 const std::string& label, const char* colour) {
  Series line{.label = label, .mark = Mark::line_points, .colour = colour, .x = {}, .y = {}, .y2 = {}};
  const std::string of = label.empty() ? "" : label + ", ";
  Series band{
      .label = of + "95 % interval of the mean", .mark = Mark::band, .colour = colour, .x = {}, .y = {}, .y2 = {}};
  for (const auto& [pass, values] : by_pass) {
    const Spread spread = spread_of(values);
    if (spread.count == 0) continue;
    line.x.push_back(pass);
    line.y.push_back(spread.mean);
    if (!std::isfinite(spread.half_width)) continue;
    band.x.push_back(pass);
    band.y.push_back(spread.mean - spread.half_width);
    band.y2.push_back(spread.mean + spread.half_width);
  }
  if (!band.x.empty()) series.push_back(std::move(band));
  if (!line.x.empty()) series.push_back(std::move(line));
}

std::map<int, std::vector<double>> by_pass(const std::vector<DrawnRun>& runs,
                                           const std::function<double(const PassRow&)>& figure) {
  std::map<int, std::vector<double>> values;
  for (const DrawnRun& run : runs)
    for (const PassRow& pass : run.passes) values[pass.number].push_back(figure(pass));
  return values;
}

Figure figure(const std::string& title, const std::string& x_label, std::vector<Panel> panels) {
  Figure made;
  made.title = title;
  made.x_label = x_label;
  made.height = static_cast<int>(120 + 260 * panels.size());
  made.whole_x = x_label == "pass";
  made.panels = std::move(panels);
  return made;
}

/// What passes say of several parameters at once, each name once; figures of effects come and go with these.
std::vector<ObjectiveRow> groups_of(const std::vector<PassRow>& passes) {
  std::vector<ObjectiveRow> groups;
  for (const PassRow& pass : passes)
    for (const ObjectiveRow& row : pass.objective)
      if (row.name.find('*') != std::string::npos &&
          std::none_of(groups.begin(), groups.end(), [&](const ObjectiveRow& one) { return one.name == row.name; }))
        groups.push_back(row);
  return groups;
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() || unit == "1" ? name : name + " (" + unit_text(unit) + ")";
}

std::vector<Panel> error_panels(const std::vector<DrawnRun>& runs) {
  std::vector<Panel> panels(1);
  panels[0].y_label = "error of the best model";
  add_by_pass(panels[0].series, by_pass(runs, [](const PassRow& pass) { return pass.best_score; }), "", kBlue);
  if (panels[0].series.empty()) return {};
  for (const ObjectiveRow& group : groups_of(runs.front().passes)) {
    Panel& panel = panels.emplace_back();
    panel.y_label = with_unit(group.name + " off by", group.unit);
    const auto value = [&](const PassRow& pass) {
      for (const ObjectiveRow& row : pass.objective)
        if (row.name == group.name) return row.value;
      return kNotKnown;
    };
    add_by_pass(panel.series, by_pass(runs, value), "", kOrange);
    if (panel.series.empty()) panels.pop_back();
  }
  return panels;
}

/// Distances of the tests that models chose, by the pass that chose them.
std::vector<Panel> transfer_panels(const std::vector<DrawnRun>& runs) {
  std::map<int, std::vector<double>> predicted, measured;
  for (const DrawnRun& run : runs)
    for (const PassRow& pass : run.passes)
      for (const TargetTrialRow& trial : run.trials) {
        if (!pass.best_test || trial.test != pass.best_test) continue;
        predicted[pass.number].push_back(trial.predicted_fitness);
        measured[pass.number].push_back(trial.measured_fitness);
      }
  Panel panel;
  panel.y_label = with_unit(runs.front().record.fitness, runs.front().record.fitness_unit);
  add_by_pass(panel.series, predicted, "model", kBlue);
  add_by_pass(panel.series, measured, "target", kOrange);
  if (panel.series.empty()) return {};
  return {panel};
}

/// The part of an address that tells elements apart: `torso` of `body.torso.mass`.
std::string short_name(const std::string& address) {
  const std::size_t first = address.find('.'), last = address.rfind('.');
  return first < last ? address.substr(first + 1, last - first - 1) : address;
}

double truth_of(const DrawnRun& run, std::size_t parameter) {
  return parameter < run.record.truth.size() ? run.record.truth[parameter] : kNotKnown;
}

/// Whether runs hide different values, so that no single truth can be drawn.
bool truths_differ(const std::vector<DrawnRun>& runs, const std::vector<std::size_t>& which) {
  return std::any_of(runs.begin(), runs.end(), [&](const DrawnRun& run) {
    return std::any_of(which.begin(), which.end(), [&](std::size_t i) {
      const double one = truth_of(run, i), other = truth_of(runs.front(), i);
      return one != other && !(std::isnan(one) && std::isnan(other));
    });
  });
}

/// Values of the last pass beside the truth; where each run hides values of its own, how far they are from it.
Panel parameter_panel(const std::vector<DrawnRun>& runs, const std::vector<std::size_t>& which) {
  const EeaRunRecord& record = runs.front().record;
  const bool errors = truths_differ(runs, which);
  Panel panel;
  const FreeValueRecord& first = record.free[which.front()];
  panel.y_label = with_unit(
      first.address.substr(first.address.rfind('.') + 1) + (errors ? ", estimate minus hidden value" : ""), first.unit);
  Series truth{.label = "truth", .mark = Mark::points, .colour = kOrange, .x = {}, .y = {}, .y2 = {}};
  Series found{.label = "models of the last pass", .mark = Mark::points, .colour = kBlue, .x = {}, .y = {}, .y2 = {}};
  const std::string bars = runs.size() > 1 ? "standard deviation between runs" : "";
  Series spread{.label = bars, .mark = Mark::whiskers, .colour = kBlue, .x = {}, .y = {}, .y2 = {}};
  for (std::size_t place = 0; place < which.size(); ++place) {
    const std::size_t i = which[place];
    std::vector<double> values;
    for (const DrawnRun& run : runs)
      if (!run.passes.empty() && i < run.passes.back().best_values.size())
        values.push_back(run.passes.back().best_values[i] - (errors ? truth_of(run, i) : 0.0));
    const Spread over_runs = spread_of(values);
    const auto x = static_cast<double>(place);
    panel.x_names.push_back(short_name(record.free[i].address));
    if (const double hidden = truth_of(runs.front(), i); std::isfinite(hidden)) {
      truth.x.push_back(x);
      truth.y.push_back(errors ? 0.0 : hidden);
    }
    if (over_runs.count == 0) continue;
    found.x.push_back(x);
    found.y.push_back(over_runs.mean);
    spread.x.push_back(x);
    spread.y.push_back(over_runs.mean - over_runs.deviation);
    spread.y2.push_back(over_runs.mean + over_runs.deviation);
  }
  for (Series* series : {&spread, &found, &truth})
    if (!series->x.empty()) panel.series.push_back(std::move(*series));
  return panel;
}

/// One figure for each kind of parameter: "mass", "delay"; none of parameters that no model and no target has.
std::vector<NamedFigure> parameter_figures(const std::vector<DrawnRun>& runs, const std::string& title) {
  const std::vector<FreeValueRecord>& free = runs.front().record.free;
  std::map<std::string, std::vector<std::size_t>> kinds;
  for (std::size_t i = 0; i < free.size(); ++i)
    kinds[free[i].address.substr(free[i].address.rfind('.') + 1)].push_back(i);
  std::vector<NamedFigure> figures;
  for (const auto& [kind, which] : kinds)
    if (Panel panel = parameter_panel(runs, which); !panel.series.empty())
      figures.push_back({"parameters_" + kind, figure(title, "", {std::move(panel)})});
  return figures;
}

/// From its start: the centres of mass of models with other masses lie elsewhere in the same pose.
Series path_series(const TimeSeries& path, const std::string& label, const char* colour) {
  Series series{.label = label, .mark = Mark::path, .colour = colour, .x = {}, .y = {}, .y2 = {}};
  for (Eigen::Index row = 0; row < path.samples.rows(); ++row) {
    series.x.push_back(path.samples(row, 0) - path.samples(0, 0));
    series.y.push_back(path.samples(row, 1) - path.samples(0, 1));
  }
  return series;
}

std::vector<Panel> path_panels(const DrawnRun& run) {
  std::vector<Panel> panels;
  for (const DrawnRun::Path& path : run.paths) {
    Panel& panel = panels.emplace_back();
    panel.y_label = fmt::format("y (m), trial {}", path.trial);
    panel.series = {path_series(path.target, "target", kOrange), path_series(path.model, "model", kBlue)};
    panel.series.front().width = kBroad;
  }
  return panels;
}

}  // namespace

DrawnRun drawn_run(const EeaStore& store) {
  DrawnRun run{store.record(), store.passes(), store.trial_rows(), {}};
  std::vector<Trial> trials = store.trials();
  for (const PassRow& pass : run.passes) {
    if (!pass.best_test || !pass.best_model) continue;
    for (std::size_t i = 0; i < run.trials.size(); ++i) {
      if (run.trials[i].test != pass.best_test) continue;
      std::optional<TimeSeries> predicted = store.predicted_path(*pass.best_model, run.trials[i].number);
      if (!predicted || trials[i].centre_of_mass.times.size() == 0) continue;
      if (run.paths.size() == 2) run.paths.pop_back();
      run.paths.push_back({run.trials[i].number, trials[i].centre_of_mass, std::move(*predicted)});
    }
  }
  return run;
}

std::vector<NamedFigure> run_figures(const std::vector<DrawnRun>& runs, const std::string& title) {
  std::vector<NamedFigure> figures;
  const auto add = [&](const std::string& name, const std::string& x_label, std::vector<Panel> panels) {
    if (!panels.empty()) figures.push_back({name, figure(title, x_label, std::move(panels))});
  };
  add("error_by_pass", "pass", error_panels(runs));
  for (NamedFigure& parameters : parameter_figures(runs, title)) figures.push_back(std::move(parameters));
  add("transfer", "pass", transfer_panels(runs));
  add("paths", "x from the start (m)", path_panels(runs.front()));
  if (figures.back().name == "paths") figures.back().figure.maps = true;
  if (runs.size() > 1 && figures.back().name == "paths") figures.back().figure.title += ", the first run";
  return figures;
}

}  // namespace lacuna
