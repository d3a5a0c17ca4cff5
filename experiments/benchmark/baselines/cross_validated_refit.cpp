#include "baselines/cross_validated_refit.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace hidden_effects {
namespace {

constexpr double kBlock = 1.0;  ///< s
constexpr double kStartStep = 1e-5;
constexpr int kStartIterations = 3, kRefitIterations = 6;
constexpr double kFailed = 1e12;  ///< squared error where a plant runs away

class LeftOut {
 public:
  LeftOut(const Observed& seen, const BaseFit& base) : seen_(seen), base_(base) {}

  /// Mean squared whitened error of each block of each left-out trial.
  std::vector<double> block_errors(const PlantModel& model, const PlantFit& full) const {
    std::vector<double> errors;
    for (std::size_t t = 0; t < seen_.trials.size(); ++t) {
      const Eigen::VectorXd left = error_without(model, full, t);
      append_blocks(left, t, errors);
    }
    return errors;
  }

 private:
  Eigen::VectorXd error_without(const PlantModel& model, const PlantFit& full, std::size_t t) const {
    std::vector<FittedTrial> others = seen_.trials;
    std::vector<Start> starts = full.starts;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(t));
    starts.erase(starts.begin() + static_cast<std::ptrdiff_t>(t));
    FitOptions options;
    options.most_iterations = kRefitIterations;
    const PlantFit fit =
        fit_plant(model, others, full.values, std::move(starts), by_deviation(base_.deviations), options);
    if (!fit.valid) return {};
    return best_start_error(model, fit.values, seen_.trials[t], full.starts[t]);
  }

  /// What is left of a trial once its start is fitted (Gauss-Newton); empty where the plant runs away.
  Eigen::VectorXd best_start_error(const PlantModel& model, const Eigen::VectorXd& values, const FittedTrial& trial,
                                   Start start) const {
    Eigen::VectorXd best = error(model, values, trial, start);
    for (int i = 0; i < kStartIterations && best.size() > 0; ++i) {
      const Eigen::Index joints = start.position.size();
      Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(best.size(), 2 * joints);
      for (Eigen::Index k = 0; k < 2 * joints; ++k) {
        Start moved = start;
        (k < joints ? moved.position[k] : moved.velocity[k - joints]) += kStartStep;
        const Eigen::VectorXd there = error(model, values, trial, moved);
        if (there.size() == best.size()) slopes.col(k) = (there - best) / kStartStep;
      }
      const Eigen::VectorXd step = slopes.colPivHouseholderQr().solve(best);
      Start next = start;
      next.position -= step.head(joints);
      next.velocity -= step.tail(joints);
      Eigen::VectorXd left = error(model, values, trial, next);
      if (left.size() != best.size() || !(left.squaredNorm() < best.squaredNorm())) break;
      start = next;
      best = std::move(left);
    }
    return best;
  }

  Eigen::VectorXd error(const PlantModel& model, const Eigen::VectorXd& values, const FittedTrial& trial,
                        const Start& start) const {
    Eigen::VectorXd predicted = whitened_prediction(model, values, {trial}, {start}, base_.deviations);
    Eigen::Index row = 0;
    if (predicted.size() > 0)
      for (std::size_t s = 0; s < trial.readings.size(); ++s)
        for (const double reading : trial.readings[s]) predicted[row++] -= reading / base_.deviations[s];
    return predicted;
  }

  void append_blocks(const Eigen::VectorXd& left, std::size_t t, std::vector<double>& errors) const {
    const auto samples = static_cast<Eigen::Index>(seen_.trials[t].readings.front().size());
    const auto sensors = static_cast<Eigen::Index>(seen_.trials[t].readings.size());
    const Eigen::Index blocks = std::max<Eigen::Index>(
        1, static_cast<Eigen::Index>(static_cast<double>(samples) * seen_.trials[t].excitation.interval / kBlock));
    for (Eigen::Index b = 0; b < blocks; ++b) {
      const Eigen::Index from = b * samples / blocks, count = (b + 1) * samples / blocks - from;
      double squares = 0.0;
      for (Eigen::Index s = 0; s < sensors && left.size() > 0; ++s)
        squares += left.segment(s * samples + from, count).squaredNorm();
      errors.push_back(left.size() > 0 ? squares / static_cast<double>(count * sensors) : kFailed);
    }
  }

  const Observed& seen_;
  const BaseFit& base_;
};

double mean(const std::vector<double>& x) {
  return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())).mean();
}

/// Of the mean of block errors.
double standard_error(const std::vector<double>& x) {
  const Eigen::Map<const Eigen::ArrayXd> errors(x.data(), static_cast<Eigen::Index>(x.size()));
  const double blocks = static_cast<double>(x.size());
  return std::sqrt((errors - errors.mean()).square().sum() / (blocks * std::max(1.0, blocks - 1.0)));
}

}  // namespace

BaselineAnswer by_cross_validated_refit(const Observed& seen, const BaseFit& base,
                                        const std::vector<Candidate>& candidates, const std::vector<CandidateFit>& fits,
                                        const std::vector<std::size_t>& order) {
  const LeftOut left_out(seen, base);
  const std::vector<double> of_base = left_out.block_errors(seen.base, base.fit);
  std::vector<double> scores, of_best = of_base;
  for (const CandidateFit& one : fits) {
    std::vector<double> errors = left_out.block_errors(one.model, one.fit);
    scores.push_back(1.0 - std::sqrt(mean(errors) / mean(of_base)));
    if (mean(errors) < mean(of_best)) of_best = std::move(errors);
  }
  BaselineAnswer answer{"cross_validated_refit", rank_fitted(candidates, fits, scores, order), 0, 0.0};
  answer.chosen = mean(of_base) > mean(of_best) + standard_error(of_best) ? 1 : 0;
  return answer;
}

}  // namespace hidden_effects
