#include "report/shape_study.h"

#include "report/spread.h"
#include "report/text_table.h"

#include <lacuna/cylinder.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lacuna {
namespace {

constexpr std::array<const char*, 7> kStudyColours = {kGrey, kOrange, kBlue, kGreen, "#CC79A7", "#56B4E9", "#E69F00"};
constexpr double kBeside = 0.05;  // passes between the bars of two experiments

const char* colour_of(std::size_t study) { return kStudyColours[study % kStudyColours.size()]; }

std::vector<double> after(const ShapeStudy& study, std::size_t pass, const char* name) {
  std::vector<double> values;
  for (const std::vector<PassRow>& run : study.runs)
    if (pass < run.size()) values.push_back(objective_of(run[pass], name));
  return values;
}

std::size_t passes_of(const ShapeStudy& study) {
  std::size_t passes = 0;
  for (const std::vector<PassRow>& run : study.runs) passes = std::max(passes, run.size());
  return passes;
}

std::string interval(const Spread& spread) {
  constexpr double kSmall = 0.01;  // three places would say little
  const auto number = [small = spread.mean < kSmall](double value) {
    return small ? fmt::format("{:.2g}", value) : fmt::format("{:.3f}", value);
  };
  return std::isfinite(spread.half_width) ? number(spread.mean) + " ± " + number(spread.half_width)
                                          : number(spread.mean);
}

/// Height of the lowest point of all, m.
double deepest(const RobotSpec& robot) {
  double lowest = kInfinity;
  for (const BodySpec& body : robot.bodies)
    for (const ShapeSpec& shape : body.shapes) lowest = std::min(lowest, lowest_point(body, shape));
  return lowest;
}

std::string right_of(const std::vector<double>& wrong) {
  return fmt::format("{} of {}", std::count(wrong.begin(), wrong.end(), 0.0), wrong.size());
}

void add_errors(const ShapeStudy& study, std::size_t index, Panel& panel) {
  Series line{
      .label = study.experiment, .mark = Mark::line_points, .colour = colour_of(index), .x = {}, .y = {}, .y2 = {}};
  Series bars{.label = "", .mark = Mark::whiskers, .colour = colour_of(index), .x = {}, .y = {}, .y2 = {}};
  for (std::size_t pass = 0; pass < passes_of(study); ++pass) {
    const Spread spread = spread_of(after(study, pass, kPartDistance));
    if (spread.count == 0) continue;
    const double x = static_cast<double>(pass + 1) + kBeside * static_cast<double>(index);
    line.x.push_back(x);
    line.y.push_back(spread.mean);
    if (!std::isfinite(spread.half_width)) continue;
    bars.x.push_back(x);
    bars.y.push_back(spread.mean - spread.half_width);
    bars.y2.push_back(spread.mean + spread.half_width);
  }
  panel.series.push_back(std::move(line));
  if (!bars.x.empty()) panel.series.push_back(std::move(bars));
}

Series shares_right(const ShapeStudy& study, std::size_t index) {
  Series line{.label = "", .mark = Mark::line_points, .colour = colour_of(index), .x = {}, .y = {}, .y2 = {}};
  for (std::size_t pass = 0; pass < passes_of(study); ++pass) {
    const std::vector<double> wrong = after(study, pass, kTopologyWrong);
    const auto right = std::count(wrong.begin(), wrong.end(), 0.0);
    line.x.push_back(static_cast<double>(pass + 1) + kBeside * static_cast<double>(index));
    line.y.push_back(static_cast<double>(right) / static_cast<double>(wrong.size()));
  }
  return line;
}

Panel progress_panel(const ShapeStudy& study, std::size_t index, bool of_score) {
  Panel panel;
  panel.y_label = of_score ? "e_s of the best model" : "e_o of the best model (m)";
  panel.x_label = of_score ? fmt::format("{}, run {}", study.experiment, study.typical) : "generations";
  Series line{.label = "", .mark = Mark::line, .colour = colour_of(index), .x = {}, .y = {}, .y2 = {}};
  for (const ProgressPoint& point : study.progress) {
    line.x.push_back(point.generations);
    line.y.push_back(of_score ? point.score : point.distance);
  }
  panel.series.push_back(std::move(line));
  return panel;
}

}  // namespace

double objective_of(const PassRow& pass, const std::string& name) {
  for (const ObjectiveRow& row : pass.objective)
    if (row.name == name) return row.value;
  return kNotKnown;
}

std::size_t typical_run(const std::vector<std::vector<PassRow>>& runs) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const double distance = runs[run].empty() ? kInfinity : objective_of(runs[run].back(), kPartDistance);
    order.emplace_back(std::isnan(distance) ? kInfinity : distance, run);
  }
  std::sort(order.begin(), order.end());
  return order[(order.size() - 1) / 2].second;
}

bool starts_below(const RobotSpec& robot, const RobotSpec& reference) {
  constexpr double kRounding = 1e-9;  // m
  return deepest(robot) < std::min(0.0, deepest(reference)) - kRounding;
}

std::string shape_table(const std::vector<ShapeStudy>& studies) {
  std::vector<std::vector<std::string>> table = {{"experiment", "runs", "e_o pass 1 (m)", "e_o last pass (m)",
                                                  "random models (m)", "last / random", "topology right",
                                                  "trilaterated (m)", "below ground"}};
  for (const ShapeStudy& study : studies) {
    const std::size_t last = std::max<std::size_t>(passes_of(study), 1) - 1;
    const Spread at_end = spread_of(after(study, last, kPartDistance));
    table.push_back(
        {study.experiment, std::to_string(study.runs.size()), interval(spread_of(after(study, 0, kPartDistance))),
         interval(at_end), fmt::format("{:.3f}", study.random_distance),
         fmt::format("{:.3f}", at_end.mean / study.random_distance), right_of(after(study, last, kTopologyWrong)),
         study.trilaterated ? fmt::format("{:.2g}", *study.trilaterated) : "-",
         fmt::format("{:.0f} %", 100.0 * study.below_ground)});
  }
  return text_table(table);
}

Figure shape_errors(const std::vector<ShapeStudy>& studies) {
  Figure figure;
  figure.title = "How far models are from the target's shape: means over the runs, bars are 95 % intervals";
  figure.x_label = "pass";
  figure.whole_x = true;
  figure.panels.resize(2);
  figure.panels[0].y_label = "e_o (m)";
  figure.panels[0].share = 2.0;
  figure.panels[1].y_label = "topology right";
  for (std::size_t i = 0; i < studies.size(); ++i) {
    add_errors(studies[i], i, figure.panels[0]);
    figure.panels[1].series.push_back(shares_right(studies[i], i));
  }
  figure.height = 760;
  return figure;
}

Figure shape_progress(const std::vector<ShapeStudy>& studies) {
  Figure figure;
  figure.title = "Progress of a typical run each: the best model of all trials so far";
  figure.columns = static_cast<int>(std::max<std::size_t>(studies.size(), 2));
  figure.width = 400 * figure.columns;
  for (const bool of_score : {true, false})
    for (std::size_t i = 0; i < studies.size(); ++i) figure.panels.push_back(progress_panel(studies[i], i, of_score));
  return figure;
}

}  // namespace lacuna
