#include "shapes/shape_study.h"

#include "foundation/unit.h"
#include "report/figures/spread.h"
#include "report/text/text_table.h"

#include <lacuna/cylinder.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lacuna {
namespace {

constexpr std::array<const char*, 7> kStudyColours = {kGrey, kOrange, kBlue, kGreen, "#CC79A7", "#56B4E9", "#E69F00"};
constexpr double kBeside = 0.05;            // passes between the bars of two experiments
constexpr double kFar = 30.0;               // times; means that differ by more cannot be read from one linear axis
constexpr std::size_t kFewestWithBars = 3;  // runs that say how far runs differ
constexpr double kTimesBeyond = 1.5;        // of a logarithmic axis, what is drawn
constexpr double kHeadroom = 1.05;          // of an axis that begins at 0
constexpr const char* kPassBorder = "#7A7A7A";

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

/// Of one of so many experiments, whose bars stand about the pass.
double place_of(std::size_t pass, std::size_t index, std::size_t studies) {
  return static_cast<double>(pass + 1) +
         kBeside * (static_cast<double>(index) - 0.5 * static_cast<double>(studies - 1));
}

bool differ_far(const std::vector<ShapeStudy>& studies) {
  double smallest = kInfinity, largest = 0.0;
  for (const ShapeStudy& study : studies)
    for (std::size_t pass = 0; pass < passes_of(study); ++pass) {
      const double mean = spread_of(after(study, pass, kPartDistance)).mean;
      if (std::isnan(mean)) continue;
      smallest = std::min(smallest, mean);
      largest = std::max(largest, mean);
    }
  return smallest > 0.0 && largest > kFar * smallest;
}

/// Ends of a mean's 95 % interval. The deviation of a mean's logarithm is the mean's over the mean.
std::array<double, 2> interval_ends(const Spread& spread, bool logarithmic) {
  if (!logarithmic) return {std::max(0.0, spread.mean - spread.half_width), spread.mean + spread.half_width};
  const double times = std::exp(spread.half_width / spread.mean);
  return {spread.mean / times, spread.mean * times};
}

/// Around all that is drawn, from 0 where it is linear.
std::array<double, 2> axis_of(const Panel& panel) {
  double low = kInfinity, high = 0.0;
  for (const Series& series : panel.series)
    for (const std::vector<double>* values : {&series.y, &series.y2})
      for (const double value : *values)
        if (std::isfinite(value)) {
          low = std::min(low, value);
          high = std::max(high, value);
        }
  if (!(high > 0.0)) return {0.0, 1.0};
  if (!panel.log_y) return {0.0, kHeadroom * high};
  return {low / kTimesBeyond, high * kTimesBeyond};
}

void add_errors(const ShapeStudy& study, std::size_t index, std::size_t studies, Panel& panel) {
  Series line{
      .label = study.experiment, .mark = Mark::line_points, .colour = colour_of(index), .x = {}, .y = {}, .y2 = {}};
  Series bars{.label = "", .mark = Mark::whiskers, .colour = colour_of(index), .x = {}, .y = {}, .y2 = {}};
  for (std::size_t pass = 0; pass < passes_of(study); ++pass) {
    const Spread spread = spread_of(after(study, pass, kPartDistance));
    if (spread.count == 0) continue;
    const double x = place_of(pass, index, studies);
    line.x.push_back(x);
    line.y.push_back(spread.mean);
    if (spread.count < kFewestWithBars) continue;
    const auto [low, high] = interval_ends(spread, panel.log_y);
    bars.x.push_back(x);
    bars.y.push_back(low);
    bars.y2.push_back(high);
  }
  panel.series.push_back(std::move(line));
  if (!bars.x.empty()) panel.series.push_back(std::move(bars));
}

Series shares_right(const ShapeStudy& study, std::size_t index, std::size_t studies) {
  Series line{.label = "", .mark = Mark::line_points, .colour = colour_of(index), .x = {}, .y = {}, .y2 = {}};
  for (std::size_t pass = 0; pass < passes_of(study); ++pass) {
    const std::vector<double> wrong = after(study, pass, kTopologyWrong);
    const auto right = std::count(wrong.begin(), wrong.end(), 0.0);
    line.x.push_back(place_of(pass, index, studies));
    line.y.push_back(static_cast<double>(right) / static_cast<double>(wrong.size()));
  }
  return line;
}

/// Where passes begin, as high as the panel.
Series pass_borders(const std::vector<ProgressPoint>& progress, const std::array<double, 2>& height) {
  Series borders{.label = "", .mark = Mark::borders, .colour = kPassBorder, .x = {}, .y = {}, .y2 = {}};
  for (std::size_t i = 1; i < progress.size(); ++i) {
    if (progress[i].pass == progress[i - 1].pass) continue;
    borders.x.push_back(0.5 * (progress[i - 1].generations + progress[i].generations));
    borders.y.push_back(height[0]);
    borders.y2.push_back(height[1]);
  }
  return borders;
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
  panel.y_range = axis_of(panel);
  if (Series borders = pass_borders(study.progress, *panel.y_range); !borders.x.empty())
    panel.series.insert(panel.series.begin(), std::move(borders));
  return panel;
}

}  // namespace

double objective_of(const PassRow& pass, const std::string& name) {
  for (const ObjectiveRow& row : pass.objective)
    if (row.name == name) return row.value;
  return kNotKnown;
}

std::string distance_text(double metres) {
  if (!std::isfinite(metres)) return "unknown";
  return format_quantity(std::stod(fmt::format("{:.1e}", metres)), "m", 2);  // else 427 µm, not 430
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
  const bool logarithmic = differ_far(studies);
  figure.title = "Distance of the models from the target's shape (mean over the runs, bars: 95 % intervals)";
  if (logarithmic) figure.title += " of the logarithms";
  figure.x_label = "pass";
  figure.whole_x = true;
  figure.panels.resize(2);
  figure.panels[0].y_label = "e_o (m)";
  figure.panels[0].share = 2.0;
  figure.panels[0].log_y = logarithmic;
  figure.panels[1].y_label = "topology right";
  figure.panels[1].y_range = {-0.05, kHeadroom};  // what is at an end does not lie on the axis
  for (std::size_t i = 0; i < studies.size(); ++i) {
    add_errors(studies[i], i, studies.size(), figure.panels[0]);
    figure.panels[1].series.push_back(shares_right(studies[i], i, studies.size()));
  }
  figure.panels[0].y_range = axis_of(figure.panels[0]);
  figure.height = 760;
  return figure;
}

Figure shape_progress(const std::vector<ShapeStudy>& studies) {
  Figure figure;
  figure.title = "Progress of a typical run of each experiment: best model on all trials so far";
  figure.columns = static_cast<int>(std::max<std::size_t>(studies.size(), 2));
  figure.width = 400 * figure.columns;
  for (const bool of_score : {true, false})
    for (std::size_t i = 0; i < studies.size(); ++i) figure.panels.push_back(progress_panel(studies[i], i, of_score));
  for (Panel& panel : figure.panels)  // one legend for all
    if (panel.series.front().mark == Mark::borders) {
      panel.series.front().label = "start of a pass";
      break;
    }
  return figure;
}

}  // namespace lacuna
