#include "diagnosis/refit/timing.h"

#include "diagnosis/refit/normal_equations.h"

#include <lacuna/error.h>

#include <Eigen/QR>

#include <algorithm>
#include <optional>

namespace lacuna {
namespace {

constexpr double kToldInformation = 9.0;  ///< whitened, in command intervals: a standard error of a third of one
constexpr double kStep = 0.25;            ///< of differences: a command is held for whole intervals

/// A base's model, simulated with commands as late as one asks.
class TimedModel {
 public:
  TimedModel(const Contender& contender, const BaseSolution& base, const RowBins& bins, int threads)
      : predictor_(*contender.model, base.trials, threads, Timing::fitted),
        space_(with_timing(contender.definition.free)),
        problem_(predictor_, space_, base.segments, base.noise),
        base_(base),
        bins_(bins) {}

  /// By segment; nothing where the model cannot be simulated.
  std::optional<std::vector<Eigen::VectorXd>> residuals(double timing) {
    std::vector<double> values = base_.values;
    values.push_back(timing);
    std::vector<Eigen::VectorXd> rows;
    if (!problem_.residuals({space_.to_coordinates(values), base_.states}, rows)) return std::nullopt;
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = bins_.means(k, rows[k]);
    return rows;
  }

  /// Between both sides of `timing`, where the residuals are `here`, or of the one that can be simulated.
  std::vector<Eigen::VectorXd> derivatives(double timing, const std::vector<Eigen::VectorXd>& here) {
    const double behind = std::max(timing - kStep, -kMostTiming), ahead = std::min(timing + kStep, kMostTiming);
    const auto before = residuals(behind), after = residuals(ahead);
    const double width = (after ? ahead : timing) - (before ? behind : timing);
    std::vector<Eigen::VectorXd> change;
    for (std::size_t k = 0; k < here.size(); ++k) {
      const Eigen::VectorXd difference = (after ? (*after)[k] : here[k]) - (before ? (*before)[k] : here[k]);
      change.emplace_back(difference / std::max(width, kStep));
    }
    return change;
  }

  const std::string& last_reason() const { return problem_.last_reason(); }

 private:
  TrialPredictor predictor_;
  ParameterSpace space_;
  ShootingProblem problem_;
  const BaseSolution& base_;
  const RowBins& bins_;
};

}  // namespace

std::vector<FreeValue> with_timing(std::vector<FreeValue> free, const TimingRange& range) {
  free.push_back({.address = "timing", .unit = "1", .lower = range.earliest, .upper = range.latest, .start = 0.0});
  return free;
}

double longest_command_interval(const std::vector<Trial>& trials) {
  double longest = 0.0;
  for (const Trial& trial : trials) longest = std::max(longest, command_interval(trial));
  return longest;
}

bool tells_timing(const Refit& fit) {
  const Eigen::Index timing = fit.covariance.rows() - 1;
  const NormalEquations equations = normal_equations(fit.weighted, timing + 1);
  std::vector<Eigen::Index> others;
  for (Eigen::Index i = 0; i < timing; ++i)
    if (!fit.at_bound[static_cast<std::size_t>(i)]) others.push_back(i);
  double information = equations.gram(timing, timing) - 1.0 / kTimingVariance;
  if (!others.empty()) {
    const Eigen::VectorXd shared = equations.gram(others, timing);
    information -= shared.dot(equations.gram(others, others).completeOrthogonalDecomposition().solve(shared));
  }
  return information > kToldInformation;
}

double freedom(const Refit& fit) {
  return static_cast<double>(fit.values.size() + (fit.timing && tells_timing(fit) ? 1 : 0));
}

void linearise_timing(const Contender& contender, const RowBins& bins, int threads, BaseSolution& base) {
  base.by_timing.clear();
  if (!base.timing) return;
  TimedModel model(contender, base, bins, threads);
  const auto residuals = model.residuals(*base.timing);
  if (!residuals) throw Error("the fitted model cannot be simulated: " + model.last_reason());
  for (std::size_t k = 0; k < residuals->size(); ++k) base.linear[k].residual = (*residuals)[k];
  base.residual = rms(base.linear);
  base.by_timing = model.derivatives(*base.timing, *residuals);
}

std::vector<LinearSegment> beside_timing(const BaseSolution& base, bool held) {
  std::vector<LinearSegment> segments = base.linear;
  for (std::size_t k = 0; k < base.by_timing.size() && !held; ++k) {
    segments[k].values.conservativeResize(Eigen::NoChange, segments[k].values.cols() + 1);
    segments[k].values.rightCols(1) = base.by_timing[k];
  }
  return segments;
}

}  // namespace lacuna
