#include "prediction/linear_prediction.h"

#include "foundation/statistics.h"
#include "fitting/starts/start_states.h"
#include "foundation/parallel.h"
#include "prediction/start_by_readings.h"
#include "prediction/start_prior.h"
#include "prediction/whitened_columns.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kFirstStep = 1e-6;  ///< of a value's range
constexpr double kWanted = 0.3;      ///< of the residual: the change of predictions that a difference should make
constexpr double kTolerated = 10.0;  ///< a step whose change is wrong by less than this factor is kept
constexpr int kStepRounds = 4;
constexpr double kSmaller = 0.3;   ///< of the residuals for which a step was chosen; below this the step is too long
constexpr double kFarSteps = 1e3;  ///< times the first step, from which on curvature is checked
constexpr double kLeastOfHalf =
    0.35;  ///< of a step's change: half the step must make this share where a derivative exists
constexpr std::size_t kForSteps = 3;  ///< stretches per length by which steps are chosen
constexpr double kStartStep = 0.3;    ///< standard deviations of a start

Eigen::VectorXd unknown_of(const PredictedStretch& stretch) {
  Eigen::VectorXd start(static_cast<Eigen::Index>(stretch.unknown.size()));
  for (Eigen::Index i = 0; i < start.size(); ++i)
    start(i) = component(stretch.start, stretch.unknown[static_cast<std::size_t>(i)]);
  return start;
}

}  // namespace

LadderPredictions::LadderPredictions(const PredictionLadder& ladder, const TrialPredictor& predictor,
                                     const ParameterSpace& space, const SmoothedStarts& starts, bool changes_readings)
    : ladder_(ladder),
      predictor_(predictor),
      space_(space),
      changed_readings_(changes_readings ? &starts : nullptr),
      warm_ups_(ladder.stretches.size()),
      predictions_(static_cast<std::size_t>(predictor.workers())) {
  for (Eigen::Index j = 0; j < space.size(); ++j)
    steps_.push_back(kFirstStep * std::min(space.upper()(j) - space.lower()(j), 1e6));
  first_steps_ = steps_;
  is_steady_.assign(steps_.size(), 1);
  step_is_for_.assign(steps_.size(), 0.0);
  for (std::size_t k = 0; k < ladder.stretches.size(); ++k) all_.push_back(k);
  for (std::size_t h = 0; h < ladder.lengths.size(); ++h) {
    std::vector<std::size_t> own;
    for (const std::size_t k : all_)
      if (ladder.stretches[k].length == h) own.push_back(k);
    const std::size_t few = std::min(kForSteps, own.size());
    for (std::size_t i = 0; i < few; ++i) few_.push_back(own[(2 * i + 1) * own.size() / (2 * few)]);
  }
  if (!predictor.model().has_memory()) return;
  for (std::size_t k = 0; k < ladder.stretches.size(); ++k) {
    const Stretch& stretch = ladder.stretches[k].stretch;
    if (stretch.first == 0) continue;
    const Eigen::VectorXd& times = predictor.trials()[stretch.trial].measured.times;
    const double* before = std::lower_bound(times.data(), times.data() + stretch.first,
                                            times(stretch.first) - kLongestMemory * (1.0 + 1e-9));
    const Eigen::Index first = std::min<Eigen::Index>(before - times.data(), stretch.first - 1);
    warm_ups_[k] = WarmUp{first, starts.at(stretch.trial, first).start};
  }
}

void LadderPredictions::take_steps_of(const LadderPredictions& other) {
  steps_ = other.steps_;
  is_steady_ = other.is_steady_;
  step_is_for_ = other.step_is_for_;
  steps_are_taken_ = true;
}

void LadderPredictions::forget_steps() {
  if (!steps_are_taken_) step_is_for_.assign(steps_.size(), 0.0);
}

PredictionPoint LadderPredictions::at_smoothed_starts(const Eigen::VectorXd& values) const {
  PredictionPoint point{values, {}};
  for (const PredictedStretch& stretch : ladder_.stretches) point.starts.push_back(unknown_of(stretch));
  return point;
}

bool LadderPredictions::simulate(std::size_t k, const Eigen::VectorXd& values, const Eigen::VectorXd& start, int worker,
                                 Eigen::VectorXd& residual) {
  predictor_.stop().throw_if_due();
  const PredictedStretch& stretch = ladder_.stretches[k];
  StartState state = stretch.start;
  for (std::size_t i = 0; i < stretch.unknown.size(); ++i)
    set_component(state, stretch.unknown[i], start(static_cast<Eigen::Index>(i)));
  Prediction& prediction = predictions_[static_cast<std::size_t>(worker)];
  const std::vector<double> of_model = space_.to_values(values);
  const WarmUp* warm_up = warm_ups_[k] ? &*warm_ups_[k] : nullptr;
  ChangedStart changed;
  if (changed_readings_) {
    changed = start_by_readings({*changed_readings_, predictor_, stretch.stretch, of_model, warm_up, worker}, state,
                                prediction);
    if (changed.reads_backwards) {
      prediction.valid = false;
      prediction.reason = "the reading of a sensor falls where the measured quantity rises";
      return false;
    }
    state = changed.start;
    warm_up = changed.warm_up ? &*changed.warm_up : nullptr;
  }
  predictor_.predict(stretch.stretch, of_model, state, worker, prediction, warm_up);
  if (!prediction.valid) return false;
  const TimeSeries::Samples& measured = predictor_.trials()[stretch.stretch.trial].measured.samples;
  residual.resize(static_cast<Eigen::Index>(stretch.rows.size()));
  for (std::size_t i = 0; i < stretch.rows.size(); ++i)
    residual(static_cast<Eigen::Index>(i)) = (measured(stretch.stretch.first + stretch.rows[i], stretch.columns[i]) -
                                              prediction.samples(stretch.rows[i], stretch.columns[i])) /
                                             ladder_.noise[stretch.channels[i]].deviation;
  return residual.allFinite();
}

bool LadderPredictions::residuals_of(const Eigen::VectorXd& values, const std::vector<Eigen::VectorXd>& starts,
                                     const std::vector<std::size_t>& which, std::vector<Eigen::VectorXd>& residuals) {
  residuals.resize(which.size());
  std::vector<char> is_valid(which.size(), 0);
  parallel_for(which.size(), predictor_.workers(), [&](std::size_t i, int worker) {
    is_valid[i] = simulate(which[i], values, starts[which[i]], worker, residuals[i]) ? 1 : 0;
  });
  simulations_ += which.size();
  if (std::find(is_valid.begin(), is_valid.end(), 0) == is_valid.end()) return true;
  for (const Prediction& prediction : predictions_)
    if (!prediction.valid) failure_ = prediction.reason;
  return false;
}

bool LadderPredictions::residuals(const PredictionPoint& point, std::vector<Eigen::VectorXd>& residuals) {
  return residuals_of(point.values, point.starts, all_, residuals);
}

/// Root mean square on the stretches by which steps are chosen, at least a reading's standard deviation.
double LadderPredictions::size_on_few(const std::vector<Eigen::VectorXd>& residuals) const {
  std::vector<Eigen::VectorXd> here;
  for (const std::size_t k : few_) here.push_back(residuals[k]);
  return std::max(1.0, root_mean_square(here));
}

/// The step of a value that changes predictions by about the wanted share of the residuals, found on a few stretches.
/// False: the value has no derivative, because half the step changes predictions by much less than half.
bool LadderPredictions::choose_step(const PredictionPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                                    Eigen::Index j) {
  std::vector<Eigen::VectorXd> moved;
  const double target = kWanted * size_on_few(residuals);
  // Uses all stretches where the few show no change: a limit may be reached in others.
  const auto change_on = [&](double way, const std::vector<std::size_t>& which) {
    Eigen::VectorXd values = point.values;
    values(j) += values(j) + way <= space_.upper()(j) ? way : -way;
    if (!residuals_of(values, point.starts, which, moved)) return -1.0;
    for (std::size_t i = 0; i < moved.size(); ++i) moved[i] -= residuals[which[i]];
    return root_mean_square(moved);
  };
  const auto change_by = [&](double way) {
    const double change = change_on(way, few_);
    return change == 0.0 ? change_on(way, all_) : change;
  };
  double& step = steps_[static_cast<std::size_t>(j)];
  const double longest = space_.logarithmic(j) ? 0.1 : 0.01 * (space_.upper()(j) - space_.lower()(j));
  double change = 0.0;
  for (int round = 0; round < kStepRounds; ++round) {
    change = change_by(step);
    const double wanted = change < 0.0   ? 0.1 * step
                          : change > 0.0 ? std::min(step * target / change, longest)
                                         : std::min(1e4 * step, longest);
    if (change >= 0.0 && wanted < kTolerated * step && wanted > step / kTolerated) break;
    step = wanted;
  }
  if (step <= kFarSteps * first_steps_[static_cast<std::size_t>(j)]) return true;
  return change_by(0.5 * step) > kLeastOfHalf * change_by(step);
}

void LadderPredictions::difference_value(const PredictionPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                                         Eigen::Index j, std::vector<LinearStretch>& stretches) {
  for (LinearStretch& stretch : stretches) stretch.values.col(j).setZero();
  char& is_steady = is_steady_[static_cast<std::size_t>(j)];
  if (!(space_.upper()(j) > space_.lower()(j))) return;
  if (double& is_for = step_is_for_[static_cast<std::size_t>(j)];
      size_on_few(residuals) < kSmaller * is_for || is_for == 0.0) {
    is_steady = choose_step(point, residuals, j) ? 1 : 0;
    is_for = size_on_few(residuals);
  }
  if (!is_steady) return;
  const double step = steps_[static_cast<std::size_t>(j)];
  const double signed_step = point.values(j) + step <= space_.upper()(j) ? step : -step;
  Eigen::VectorXd values = point.values;
  values(j) += signed_step;
  std::vector<Eigen::VectorXd> moved;
  if (!residuals_of(values, point.starts, all_, moved)) return;
  for (std::size_t k = 0; k < moved.size(); ++k) stretches[k].values.col(j) = (residuals[k] - moved[k]) / signed_step;
}

void LadderPredictions::difference_starts(const PredictionPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                                          std::vector<LinearStretch>& stretches) {
  parallel_for(stretches.size(), predictor_.workers(), [&](std::size_t k, int worker) {
    Eigen::VectorXd start = point.starts[k], moved;
    for (Eigen::Index i = 0; i < start.size(); ++i) {
      const double step = kStartStep * std::sqrt(ladder_.stretches[k].covariance(i, i));
      start(i) += step;
      if (simulate(k, point.values, start, worker, moved)) stretches[k].start.col(i) = (residuals[k] - moved) / step;
      start(i) = point.starts[k](i);
    }
  });
  for (const LinearStretch& stretch : stretches) simulations_ += static_cast<std::uint64_t>(stretch.start.cols());
}

void LadderPredictions::put_residuals(const PredictionPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                                      std::vector<LinearStretch>& stretches) const {
  for (std::size_t k = 0; k < residuals.size(); ++k)
    stretches[k].residual = residuals[k] + stretches[k].start * (point.starts[k] - unknown_of(ladder_.stretches[k]));
}

bool LadderPredictions::residuals_at(const PredictionPoint& point, std::vector<LinearStretch>& stretches) {
  std::vector<Eigen::VectorXd> found;
  if (!residuals(point, found)) return false;
  for (std::size_t k = 0; k < found.size(); ++k) stretches[k].values.resize(found[k].size(), 0);
  put_residuals(point, found, stretches);
  return true;
}

std::optional<LinearPrediction> LadderPredictions::linearise(const PredictionPoint& point) {
  std::vector<Eigen::VectorXd> residuals;
  if (!residuals_of(point.values, point.starts, all_, residuals)) return std::nullopt;
  LinearPrediction linear;
  linear.stretches.resize(residuals.size());
  linearise_starts(point, residuals, linear);
  linearise_values(point, residuals, linear);
  return linear;
}

void LadderPredictions::linearise_values(const PredictionPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                                         LinearPrediction& linear, const std::vector<bool>& stays) {
  for (std::size_t k = 0; k < residuals.size(); ++k)
    linear.stretches[k].values.conservativeResize(residuals[k].size(), space_.size());
  for (Eigen::Index j = 0; j < space_.size(); ++j)
    if (stays.empty() || !stays[static_cast<std::size_t>(j)]) difference_value(point, residuals, j, linear.stretches);
  put_residuals(point, residuals, linear.stretches);
  linear.products = whitened_products(ladder_, linear.stretches);
}

void LadderPredictions::linearise_starts(const PredictionPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                                         LinearPrediction& linear) {
  for (std::size_t k = 0; k < residuals.size(); ++k)
    linear.stretches[k].start = Eigen::MatrixXd::Zero(residuals[k].size(), point.starts[k].size());
  difference_starts(point, residuals, linear.stretches);
  if (linear.stretches.empty() || linear.stretches.front().values.rows() == 0) return;  // values not linearised yet
  put_residuals(point, residuals, linear.stretches);
  linear.products = whitened_products(ladder_, linear.stretches);
}

std::vector<Eigen::VectorXd> moved_starts(const PredictionLadder& ladder, const LinearPrediction& linear,
                                          const Eigen::VectorXd& step) {
  std::vector<Eigen::VectorXd> starts;
  for (std::size_t k = 0; k < linear.stretches.size(); ++k) {
    const LinearStretch& stretch = linear.stretches[k];
    Eigen::VectorXd& start = starts.emplace_back(unknown_of(ladder.stretches[k]));
    if (start.size() == 0) continue;
    const StartPrior prior = prior_of(ladder.stretches[k].covariance);
    const Eigen::MatrixXd by_start = stretch.start * prior.deviation.asDiagonal();
    const Eigen::MatrixXd normal = prior.precision + by_start.transpose() * by_start;
    const Eigen::VectorXd left = stretch.residual - stretch.values * step;
    start += prior.deviation.cwiseProduct(normal.ldlt().solve(by_start.transpose() * left));
  }
  return starts;
}

}  // namespace lacuna
