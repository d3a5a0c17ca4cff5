#include "where_it_fails/where_it_fails.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kAtTheFloor = 1.2;   // times the floor; with less there is nothing to find
constexpr double kLeastRegime = 0.1;  // share of squared error
constexpr double kGathered = 1.5;     // share of error over share of samples
constexpr double kLeastPart = 0.2, kLeastMajority = 0.5;
constexpr double kWorthASay = 0.01;  // share of squares
constexpr double kFindingLevel = 0.01;

class Collector {
 public:
  explicit Collector(const Comparison& comparison) : comparison_(comparison) {}

  void look_at(const ResidualView& view) {
    for (const ChannelTests& tests : view.channels) dependence(view, tests);
    if (!(view.times_floor > kAtTheFloor)) return;
    for (const Regime& regime : view.regimes) gathered(view, regime);
    if (view.kind != ViewKind::free_run) return;
    for (const ChannelTests& tests : view.channels) {
      offset(view, tests);
      magnitude(tests);
    }
    majority_trial();
  }

  std::vector<Finding> ranked() {
    std::erase_if(findings_, [](const Finding& finding) { return finding.share < kWorthASay; });
    std::stable_sort(findings_.begin(), findings_.end(),
                     [](const Finding& a, const Finding& b) { return a.share > b.share; });
    return std::move(findings_);
  }

 private:
  void gathered(const ResidualView& view, const Regime& regime) {
    if (regime.share_of_error < kLeastRegime || regime.share_of_error < kGathered * regime.share_of_samples) return;
    findings_.push_back({.kind = FindingKind::regime,
                         .share = regime.share_of_error,
                         .view = view.kind,
                         .share_of_samples = regime.share_of_samples,
                         .conditions = regime.conditions});
  }

  /// One finding a channel: what the residual depends on.
  void dependence(const ResidualView& view, const ChannelTests& tests) {
    if (tests.selected.empty()) return;
    Finding finding{.kind = FindingKind::dependence, .view = view.kind, .channel = tests.channel};
    for (const ChannelTests::Selected& one : tests.selected) {
      finding.features.push_back(one.feature);
      finding.share += one.share * tests.share_of_error;
    }
    finding.not_on = tests.not_on;
    finding.p = tests.selected.front().p;
    finding.unit = tests.unit;
    findings_.push_back(std::move(finding));
  }

  void offset(const ResidualView& view, const ChannelTests& tests) {
    const double p = std::min(1.0, tests.mean.p * static_cast<double>(view.channels.size()));
    if (!tests.mean.testable || p >= kFindingLevel || tests.mean.share < kLeastPart) return;
    double sum = 0.0, count = 0.0;
    for (const auto& [trial, score] : scores(tests)) {
      sum += score->bias * static_cast<double>(score->samples);
      count += static_cast<double>(score->samples);
    }
    findings_.push_back({.kind = FindingKind::offset,
                         .share = tests.mean.share * tests.share_of_error,
                         .channel = tests.channel,
                         .p = p,
                         .size = sum / count,
                         .unit = tests.unit});
  }

  /// The error that one common factor on the swings of all trials would remove; swings that are too wide in one trial
  /// and too narrow in another have no common factor.
  void magnitude(const ChannelTests& tests) {
    double squares = 0.0, motion = 0.0, excess = 0.0;
    for (const auto& [trial, score] : scores(tests)) {
      if (!(score->normalised_rmse > 0.0) || !std::isfinite(score->parts.spread_error)) continue;
      const double power = static_cast<double>(score->samples) * score->rmse * score->rmse;
      const double swing = power / (score->normalised_rmse * score->normalised_rmse);
      squares += power;
      motion += swing;
      excess += swing * score->parts.spread_error;
    }
    if (!(squares > 0.0) || excess * excess / motion < kLeastPart * squares) return;
    findings_.push_back({.kind = FindingKind::magnitude,
                         .share = excess * excess / motion / squares * tests.share_of_error,
                         .channel = tests.channel,
                         .size = excess / motion});
  }

  void majority_trial() {
    std::vector<double> error, samples;
    double all_error = 0.0, all_samples = 0.0;
    for (const TrialComparison& trial : comparison_.trials) {
      error.push_back(0.0);
      samples.push_back(0.0);
      if (trial.held_out || !trial.valid) continue;
      for (const ChannelScore& score : trial.channels) {
        if (score.samples == 0 || !std::isfinite(score.times_floor)) continue;
        error.back() += static_cast<double>(score.samples) * score.times_floor * score.times_floor;
        samples.back() += static_cast<double>(score.samples);
      }
      all_error += error.back();
      all_samples += samples.back();
    }
    for (std::size_t t = 0; t < error.size(); ++t) {
      const double share = error[t] / all_error, of_samples = samples[t] / all_samples;
      if (share >= kLeastMajority && share >= kGathered * of_samples)
        findings_.push_back({.kind = FindingKind::trial,
                             .share = share,
                             .trial = comparison_.trials[t].trial,
                             .share_of_samples = of_samples});
    }
  }

  /// Of a channel in the fit trials that were scored.
  std::vector<std::pair<const TrialComparison*, const ChannelScore*>> scores(const ChannelTests& tests) const {
    std::vector<std::pair<const TrialComparison*, const ChannelScore*>> all;
    for (const TrialComparison& trial : comparison_.trials)
      for (const ChannelScore& score : trial.channels)
        if (!trial.held_out && trial.valid && score.samples > 0 && score.channel == tests.channel)
          all.emplace_back(&trial, &score);
    return all;
  }

  const Comparison& comparison_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> findings_of(const Comparison& comparison, const std::vector<ResidualView>& views) {
  Collector collector(comparison);
  for (const ResidualView& view : views) collector.look_at(view);
  return collector.ranked();
}

}  // namespace lacuna
