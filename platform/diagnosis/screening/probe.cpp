#include "diagnosis/screening/probe.h"

#include "diagnosis/screening/probe_sizes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace lacuna {
namespace {

constexpr double kLadderTime = 4.0;  ///< s of segments that sizes are looked for on
constexpr double kEnough = 0.5;      ///< of the residual
constexpr double kAimedAt = 1.0;     ///< of the residual
constexpr double kSame = 1e-9;       ///< of the sensor noise

/// Simulates a hypothesis at the base's solution, on some of its segments.
class Bench {
 public:
  /// `predictor`: of the hypothesis's model.
  Bench(const Hypothesis& hypothesis, const TrialPredictor& predictor, const BaseSolution& base,
        std::vector<std::size_t> segments)
      : hypothesis_(hypothesis),
        base_(base),
        space_(hypothesis.definition.free),
        segments_(std::move(segments)),
        problem_(predictor, space_, chosen(base), base.noise) {}

  bool residuals(const std::vector<double>& own, std::vector<Eigen::VectorXd>& residuals) {
    return problem_.residuals({space_.to_coordinates(hypothesis_.values(base_.values, own)), states_}, residuals);
  }
  /// Why the last simulation that failed did; empty: none did.
  const std::string& failure() const { return problem_.last_reason(); }
  /// Segments of the base that are simulated.
  const std::vector<std::size_t>& segments() const { return segments_; }

 private:
  std::vector<Segment> chosen(const BaseSolution& base) {
    std::vector<Segment> kept;
    for (const std::size_t k : segments_) {
      kept.push_back(base.segments[k]);
      states_.push_back(base.states[k]);
    }
    return kept;
  }

  const Hypothesis& hypothesis_;
  const BaseSolution& base_;
  ParameterSpace space_;
  std::vector<std::size_t> segments_;
  std::vector<Eigen::VectorXd> states_;
  ShootingProblem problem_;
};

std::vector<std::size_t> all_segments(const BaseSolution& base) {
  std::vector<std::size_t> all(base.segments.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

/// Segments that sizes are looked for on, which need not be exact: half of them those in which the base leaves most,
/// where an effect that is rarely there (an end stop) shows, and others evenly spread.
std::vector<std::size_t> segments_for_sizes(const BaseSolution& base) {
  double longest = 0.0;
  for (const Segment& segment : base.segments) longest = std::max(longest, duration_of(segment, base.trials));
  const auto wanted = static_cast<std::size_t>(std::ceil(kLadderTime / longest));
  std::vector<std::size_t> by_size = all_segments(base);
  if (wanted >= by_size.size()) return by_size;
  const auto left = [&](std::size_t k) { return base.linear[k].residual.squaredNorm(); };
  std::stable_sort(by_size.begin(), by_size.end(), [&](std::size_t a, std::size_t b) { return left(a) > left(b); });
  std::set<std::size_t> chosen;
  const std::size_t even = wanted / 2;
  for (std::size_t i = 0; i < even; ++i) chosen.insert(i * base.segments.size() / even);
  for (std::size_t i = 0; chosen.size() < wanted; ++i) chosen.insert(by_size[i]);
  return {chosen.begin(), chosen.end()};
}

/// Whether the hypothesis, neutral, predicts what the base does.
bool starts_at_base(const std::vector<Eigen::VectorXd>& calm, const std::vector<std::size_t>& segments,
                    const BaseSolution& base, const RowBins& bins) {
  for (std::size_t i = 0; i < calm.size(); ++i) {
    const Eigen::VectorXd change = bins.means(segments[i], calm[i]) - base.linear[segments[i]].residual;
    if (!(change.cwiseAbs().maxCoeff() <= kSame)) return false;
  }
  return true;
}

}  // namespace

std::vector<Probe> find_probes(const Hypothesis& hypothesis, const BaseSolution& base, const RowBins& bins,
                               const std::map<std::string, double>& scales, std::string& failure) {
  const TrialPredictor predictor(*hypothesis.model, base.trials, 1);
  Bench few(hypothesis, predictor, base, segments_for_sizes(base));
  const OwnResiduals simulate = [&](const std::vector<double>& own, std::vector<Eigen::VectorXd>& residuals) {
    return few.residuals(own, residuals);
  };
  std::vector<Probe> probes;
  for (SizedProbe& sized : size_probes(hypothesis, simulate, {kEnough, kAimedAt, base.free_run}, scales))
    probes.push_back({std::move(sized.own), sized.one_sided, {}});
  failure = few.failure();
  if (probes.empty()) return {};
  Bench bench(hypothesis, predictor, base, all_segments(base));
  std::vector<Eigen::VectorXd> calm, moved;
  if (!few.residuals(hypothesis.neutral, calm)) return {};
  if (starts_at_base(calm, few.segments(), base, bins)) {
    calm.clear();
    for (const LinearSegment& segment : base.linear) calm.push_back(segment.residual);
  } else {
    if (!bench.residuals(hypothesis.neutral, calm)) {
      failure = bench.failure();
      return {};
    }
    for (std::size_t k = 0; k < calm.size(); ++k) calm[k] = bins.means(k, calm[k]);
  }
  for (Probe& probe : probes) {
    if (!bench.residuals(probe.own, moved)) continue;
    for (std::size_t k = 0; k < calm.size(); ++k) probe.response.emplace_back(calm[k] - bins.means(k, moved[k]));
  }
  std::erase_if(probes, [](const Probe& probe) { return probe.response.empty(); });
  if (!bench.failure().empty()) failure = bench.failure();
  return probes;
}

}  // namespace lacuna
