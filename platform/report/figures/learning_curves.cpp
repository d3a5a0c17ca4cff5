#include "report/figures/learning_curves.h"

#include "report/text/text_table.h"

#include <lacuna/random_stream.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lacuna {
namespace {

constexpr std::array<const char*, 6> kCurveColours = {kOrange, kBlue, kGreen, "#CC79A7", "#56B4E9", "#E69F00"};
constexpr double kApart = 0.06;      // trials between the bars of two experiments, of few
constexpr double kMostApart = 0.3;   // of the first and the last
constexpr std::size_t kFewest = 3;   // runs that say how far runs differ
constexpr int kSamples = 1000;       // of the bootstrap
constexpr std::uint64_t kSeed = 62;  // of the bootstrap

const ObjectiveRow* objective_row(const PassRow& pass, const std::string& name) {
  for (const ObjectiveRow& row : pass.objective)
    if (row.name == name) return &row;
  return nullptr;
}

int most_trials(const LearningCurve& curve) {
  int most = 0;
  for (const auto& run : curve.runs)
    if (!run.empty()) most = std::max(most, run.back().trials);
  return most;
}

/// The last point that took at most so many trials; nothing before the first.
const LearningCurve::Point* point_after(const std::vector<LearningCurve::Point>& run, int trials) {
  const LearningCurve::Point* last = nullptr;
  for (const LearningCurve::Point& point : run)
    if (point.trials <= trials) last = &point;
  return last;
}

double mean_steps(const LearningCurve& curve, int trials) {
  std::vector<double> steps;
  for (const auto& run : curve.runs)
    if (const LearningCurve::Point* point = point_after(run, trials)) steps.push_back(point->steps);
  return spread_of(steps).mean;
}

/// Runs drawn with replacement.
LearningCurve resampled(const LearningCurve& curve, RandomStream& random) {
  LearningCurve sample{curve.experiment, curve.error, curve.unit, {}};
  for (std::size_t i = 0; i < curve.runs.size(); ++i)
    sample.runs.push_back(curve.runs[random.index(curve.runs.size())]);
  return sample;
}

std::string needed_text(const TrialsNeeded& needed, int most) {
  if (!needed.trials) return fmt::format("more than {}", most);
  const auto bound = [&](const std::optional<int>& trials) {
    return trials ? std::to_string(*trials) : fmt::format("> {}", most);
  };
  return fmt::format("{} [{}, {}]", *needed.trials, bound(needed.lower), bound(needed.upper));
}

std::string interval_cell(const MeanError::Interval& interval) {
  if (!std::isfinite(interval.upper - interval.lower)) return fmt::format("{:.3g}", interval.mean);
  return fmt::format("{:.3g} [{:.3g}, {:.3g}]", interval.mean, interval.lower, interval.upper);
}

std::string error_label(const LearningCurve& curve) {
  return curve.unit.empty() || curve.unit == "1" ? curve.error : fmt::format("{} ({})", curve.error, curve.unit);
}

/// A line with bars; `x_of` says where a trial's point stands.
template <class PlaceOf>
void add_curve(Panel& panel, const LearningCurve& curve, std::size_t index, const MeanError& mean, PlaceOf x_of) {
  const char* colour = kCurveColours[index % kCurveColours.size()];
  Series line{.label = curve.experiment, .mark = Mark::line_points, .colour = colour, .x = {}, .y = {}, .y2 = {}};
  Series bars{.label = "", .mark = Mark::whiskers, .colour = colour, .x = {}, .y = {}, .y2 = {}};
  for (int trials = 1; trials <= most_trials(curve); ++trials) {
    const MeanError::Interval interval = mean.after(curve, trials);
    if (!std::isfinite(interval.mean)) continue;
    line.x.push_back(x_of(trials));
    line.y.push_back(interval.mean);
    if (!std::isfinite(interval.upper - interval.lower)) continue;
    bars.x.push_back(x_of(trials));
    bars.y.push_back(interval.lower);
    bars.y2.push_back(interval.upper);
  }
  panel.series.push_back(std::move(line));
  if (!bars.x.empty()) panel.series.push_back(std::move(bars));
}

Figure curve_figure(const std::vector<LearningCurve>& curves, const MeanError& mean, const std::string& x_label) {
  Figure figure;
  figure.title = "Error of the best model (mean over the runs, bars: 95 % intervals)";
  figure.x_label = x_label;
  figure.panels.resize(1);
  figure.panels[0].y_label = curves.empty() ? "" : error_label(curves.front());
  figure.panels[0].log_y = mean.logarithmic();
  return figure;
}

}  // namespace

std::vector<std::string> errors_in(const std::vector<std::vector<PassRow>>& runs) {
  std::vector<std::string> names;
  for (const std::vector<PassRow>& run : runs) {
    if (run.empty()) continue;
    for (const ObjectiveRow& row : run.back().objective) names.push_back(row.name);
    break;
  }
  std::erase_if(names, [&](const std::string& name) {
    return std::any_of(runs.begin(), runs.end(), [&](const std::vector<PassRow>& run) {
      return !run.empty() && !objective_row(run.back(), name);
    });
  });
  std::stable_partition(names.begin(), names.end(),
                        [](const std::string& name) { return name.find('*') != std::string::npos; });
  return names;
}

LearningCurve learning_curve(const std::string& experiment, const std::vector<std::vector<PassRow>>& runs,
                             const std::string& error) {
  LearningCurve curve{experiment, error.empty() ? "score" : error, "", {}};
  for (const std::vector<PassRow>& run : runs) {
    std::vector<LearningCurve::Point>& points = curve.runs.emplace_back();
    double steps = 0.0;
    for (const PassRow& pass : run) {
      steps += static_cast<double>(pass.steps + pass.test_steps);
      const ObjectiveRow* row = objective_row(pass, error);
      if (pass.number == 0 || (!error.empty() && !row)) continue;
      if (row) curve.unit = row->unit;
      points.push_back({pass.number, steps, row ? row->value : pass.best_score});
    }
  }
  return curve;
}

MeanError::MeanError(const std::vector<LearningCurve>& curves) {
  logarithmic_ = true;
  for (const LearningCurve& curve : curves)
    for (const auto& run : curve.runs)
      for (const LearningCurve::Point& point : run) logarithmic_ = logarithmic_ && !(point.error <= 0.0);
}

MeanError::Interval MeanError::after(const LearningCurve& curve, int trials) const {
  std::vector<double> errors;
  for (const auto& run : curve.runs)
    if (const LearningCurve::Point* point = point_after(run, trials))
      errors.push_back(logarithmic_ ? std::log(point->error) : point->error);
  Spread spread = spread_of(errors);
  if (spread.count < kFewest) spread.half_width = kNotKnown;
  const auto back = [&](double value) { return logarithmic_ ? std::exp(value) : value; };
  const double lower = back(spread.mean - spread.half_width);
  return {back(spread.mean), lower < 0.0 ? 0.0 : lower, back(spread.mean + spread.half_width)};  // no error is negative
}

std::optional<int> MeanError::trials_to(const LearningCurve& curve, double error) const {
  for (int trials = 1; trials <= most_trials(curve); ++trials)
    if (after(curve, trials).mean <= error) return trials;
  return std::nullopt;
}

TrialsNeeded trials_needed(const MeanError& mean, const LearningCurve& curve, const LearningCurve& against) {
  const auto needed = [&](const LearningCurve& of, const LearningCurve& other) {
    return mean.trials_to(of, mean.after(other, most_trials(other)).mean);
  };
  std::vector<int> samples;
  const int never = most_trials(curve) + 1;
  RandomStream random(std::array<std::uint64_t, 1>{kSeed});
  for (int i = 0; i < kSamples && !curve.runs.empty() && !against.runs.empty(); ++i)
    samples.push_back(needed(resampled(curve, random), resampled(against, random)).value_or(never));
  std::sort(samples.begin(), samples.end());
  const auto quantile = [&](double share) -> std::optional<int> {
    if (samples.empty()) return std::nullopt;
    const int trials = samples[static_cast<std::size_t>(share * static_cast<double>(samples.size() - 1))];
    return trials == never ? std::nullopt : std::optional(trials);
  };
  return {needed(curve, against), quantile(0.025), quantile(0.975)};
}

std::string learning_table(const std::vector<LearningCurve>& curves, const LearningCurve* against) {
  std::vector<std::vector<std::string>> table = {
      {"experiment", "runs", "error", "after 1 trial", "half way", "last", "trials", "steps"}};
  if (against) table.front().push_back("trials to reach the final error of " + against->experiment);
  const MeanError mean(curves);
  for (const LearningCurve& curve : curves) {
    const int most = most_trials(curve);
    table.push_back({curve.experiment, std::to_string(curve.runs.size()), error_label(curve),
                     interval_cell(mean.after(curve, 1)), interval_cell(mean.after(curve, std::max(1, most / 2))),
                     interval_cell(mean.after(curve, most)), std::to_string(most),
                     fmt::format("{:.2g}", mean_steps(curve, most))});
    if (against) table.back().push_back(needed_text(trials_needed(mean, curve, *against), most));
  }
  return text_table(table);
}

Figure error_by_trials(const std::vector<LearningCurve>& curves) {
  const MeanError mean(curves);
  Figure figure = curve_figure(curves, mean, "trials of the target");
  figure.whole_x = true;
  const double apart = std::min(kApart, kMostApart / static_cast<double>(std::max<std::size_t>(1, curves.size())));
  for (std::size_t i = 0; i < curves.size(); ++i)
    add_curve(figure.panels[0], curves[i], i, mean,
              [&](int trials) { return static_cast<double>(trials) + apart * static_cast<double>(i); });
  return figure;
}

Figure error_by_steps(const std::vector<LearningCurve>& curves) {
  const MeanError mean(curves);
  Figure figure = curve_figure(curves, mean, "simulated steps");
  figure.log_x = true;
  for (std::size_t i = 0; i < curves.size(); ++i)
    add_curve(figure.panels[0], curves[i], i, mean, [&](int trials) { return mean_steps(curves[i], trials); });
  return figure;
}

}  // namespace lacuna
