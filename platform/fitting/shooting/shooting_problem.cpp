#include "fitting/shooting/shooting_problem.h"

#include "foundation/statistics.h"
#include "foundation/parallel.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

/// A step should change the prediction by about this share of the residual: far above the small jumps of a simulation
/// with dry friction, which sticks at whole steps, and below the range of curvature.
constexpr double kWantedChange = 0.5;
constexpr double kTolerated = 10.0;  ///< steps whose change is wrong by less than this factor stay
constexpr int kStepRounds = 4;

double rms(double sum_of_squares, double count) { return count > 0.0 ? std::sqrt(sum_of_squares / count) : 0.0; }

}  // namespace

ShootingProblem::ShootingProblem(const TrialPredictor& predictor, const ParameterSpace& space,
                                 std::vector<Segment> segments, const std::vector<ChannelNoise>& noise)
    : predictor_(predictor), space_(space), segments_(std::move(segments)), noise_(noise) {
  for (const Trial& trial : predictor_.trials()) {
    std::vector<std::size_t> channels;
    for (const Channel& channel : trial.measured.channels)
      for (std::size_t i = 0; i < noise_.size(); ++i)
        if (noise_[i].channel == channel.name) channels.push_back(i);
    channel_of_.push_back(std::move(channels));
  }
  for (const ChannelNoise& channel : noise_) scales_.push_back(channel.deviation);
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    samples_ += segments_[k].rows.size();
    for (Eigen::Index j = 0; j < space_.size() + segments_[k].deviation.size(); ++j) columns_.push_back({k, j});
  }
  for (Eigen::Index j = 0; j < space_.size(); ++j)
    steps_.push_back(1e-7 * std::min(space_.upper()(j) - space_.lower()(j), 1e6));
  steps_.resize(steps_.size() + 2 * predictor_.model().coordinates().size(), 1e-7);
  predictions_.resize(static_cast<std::size_t>(predictor_.workers()));
}

ShootingProblem::ShootingProblem(const ShootingProblem& other, const TrialPredictor& predictor)
    : predictor_(predictor),
      space_(other.space_),
      segments_(other.segments_),
      noise_(other.noise_),
      channel_of_(other.channel_of_),
      scales_(other.scales_),
      steps_(other.steps_),
      columns_(other.columns_),
      predictions_(static_cast<std::size_t>(predictor.workers())),
      samples_(other.samples_) {}

void ShootingProblem::count_in(const ShootingProblem& other) {
  simulations_ += other.simulations_;
  invalid_ += other.invalid_;
  if (!other.reason_.empty()) reason_ = other.reason_;
}

FitPoint ShootingProblem::start(const Eigen::VectorXd& values) const {
  FitPoint point{values, {}};
  for (const Segment& segment : segments_) {
    Eigen::VectorXd state(segment.deviation.size());
    for (Eigen::Index j = 0; j < state.size(); ++j)
      state(j) = component(segment.start, segment.unknown[static_cast<std::size_t>(j)]);
    point.states.push_back(state);
  }
  return point;
}

ResidualPlace ShootingProblem::place(std::size_t k, Eigen::Index row) const {
  const Segment& segment = segments_[k];
  const auto i = static_cast<std::size_t>(row);
  const std::size_t trial = segment.stretch.trial;
  return {trial, predictor_.trials()[trial].measured.times(segment.stretch.first + segment.rows[i]),
          channel_of_[trial][static_cast<std::size_t>(segment.columns[i])]};
}

bool ShootingProblem::segment_residuals(std::size_t k, const Eigen::VectorXd& values, const Eigen::VectorXd& state,
                                        int worker, Eigen::VectorXd& residuals) {
  predictor_.stop().throw_if_due();
  const Segment& segment = segments_[k];
  StartState start = segment.start;
  for (std::size_t j = 0; j < segment.unknown.size(); ++j)
    set_component(start, segment.unknown[j], state(static_cast<Eigen::Index>(j)));
  Prediction& prediction = predictions_[static_cast<std::size_t>(worker)];
  predictor_.predict(segment.stretch, space_.to_values(values), start, worker, prediction,
                     segment.warm_up ? &*segment.warm_up : nullptr);
  ++simulations_;
  if (!prediction.valid) {
    ++invalid_;
    return false;
  }
  const TimeSeries::Samples& measured = predictor_.trials()[segment.stretch.trial].measured.samples;
  const std::vector<std::size_t>& channels = channel_of_[segment.stretch.trial];
  const auto scored = static_cast<Eigen::Index>(segment.rows.size());
  residuals.resize(scored + state.size());
  for (Eigen::Index i = 0; i < scored; ++i) {
    const Eigen::Index row = segment.rows[static_cast<std::size_t>(i)];
    const Eigen::Index column = segment.columns[static_cast<std::size_t>(i)];
    residuals(i) = (measured(segment.stretch.first + row, column) - prediction.samples(row, column)) /
                   scales_[channels[static_cast<std::size_t>(column)]];
  }
  for (Eigen::Index j = 0; j < state.size(); ++j)
    residuals(scored + j) =
        (state(j) - component(segment.start, segment.unknown[static_cast<std::size_t>(j)])) / segment.deviation(j);
  return true;
}

bool ShootingProblem::residuals(const FitPoint& point, std::vector<Eigen::VectorXd>& residuals) {
  residuals.resize(segments_.size());
  std::vector<std::string> failures(segments_.size());
  parallel_for(segments_.size(), predictor_.workers(), [&](std::size_t k, int worker) {
    if (!segment_residuals(k, point.values, point.states[k], worker, residuals[k]))
      failures[k] = predictions_[static_cast<std::size_t>(worker)].reason + " ";
  });
  const auto failed = std::find_if(failures.begin(), failures.end(), [](const std::string& f) { return !f.empty(); });
  if (failed == failures.end()) return true;
  reason_ = *failed;
  return false;
}

void ShootingProblem::linearize(const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                                std::vector<SegmentJacobian>& jacobians) {
  jacobians.resize(segments_.size());
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    jacobians[k].values.resize(residuals[k].size(), space_.size());
    jacobians[k].state.resize(residuals[k].size(), segments_[k].deviation.size());
  }
  differentiate({point, residuals}, columns_, jacobians);
}

void ShootingProblem::linearize_states(const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                                       std::vector<SegmentJacobian>& jacobians) {
  jacobians.resize(segments_.size());
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    jacobians[k].values.resize(residuals[k].size(), 0);
    jacobians[k].state.resize(residuals[k].size(), segments_[k].deviation.size());
  }
  std::vector<Column> columns = columns_;
  std::erase_if(columns, [&](const Column& column) { return is_shared(column); });
  differentiate({point, residuals}, std::move(columns), jacobians);
}

void ShootingProblem::linearize_finely(const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                                       std::vector<SegmentJacobian>& jacobians) {
  linearize(point, residuals, jacobians);  // finds the steps
  difference({point, residuals}, columns_, true, jacobians);
}

void ShootingProblem::differentiate(const Origin& origin, std::vector<Column> columns,
                                    std::vector<SegmentJacobian>& jacobians) {
  double sum = 0.0;
  for (const Eigen::VectorXd& residual : origin.residuals) sum += residual.squaredNorm();
  const double target = kWantedChange * std::max(noise_over_scale(), rms(sum, static_cast<double>(samples_)));
  for (int round = 0; round < kStepRounds && !columns.empty(); ++round) {
    difference(origin, columns, false, jacobians);
    const std::vector<bool> again = adapt_steps(jacobians, columns, target);
    std::erase_if(columns, [&](const Column& column) { return !again[kind(column)]; });
  }
}

double ShootingProblem::noise_over_scale() const {
  double least = 1.0;
  for (std::size_t i = 0; i < scales_.size(); ++i) least = std::min(least, noise_[i].deviation / scales_[i]);
  return least;
}

std::size_t ShootingProblem::kind(const Column& column) const {
  if (column.index < space_.size()) return static_cast<std::size_t>(column.index);
  const auto which = static_cast<std::size_t>(column.index - space_.size());
  return static_cast<std::size_t>(space_.size() + segments_[column.segment].unknown[which]);
}

void ShootingProblem::difference(const Origin& origin, const std::vector<Column>& columns, bool central,
                                 std::vector<SegmentJacobian>& jacobians) {
  parallel_for(columns.size(), predictor_.workers(), [&](std::size_t i, int worker) {
    const Column& column = columns[i];
    SegmentJacobian& jacobian = jacobians[column.segment];
    auto derivative =
        is_shared(column) ? jacobian.values.col(column.index) : jacobian.state.col(column.index - space_.size());
    if (!difference_column(origin, column, central, worker, derivative)) derivative.setZero();
  });
}

bool ShootingProblem::difference_column(const Origin& origin, const Column& column, bool central, int worker,
                                        Eigen::Ref<Eigen::VectorXd> derivative) {
  const bool shared = is_shared(column);
  const Eigen::Index j = shared ? column.index : column.index - space_.size();
  const double step = steps_[kind(column)];
  const Eigen::VectorXd& residuals = origin.residuals[column.segment];
  Eigen::VectorXd values = origin.point.values;
  Eigen::VectorXd state = origin.point.states[column.segment];
  double& moving = shared ? values(j) : state(j);
  const double at = moving;
  Eigen::VectorXd ahead, behind;
  const auto evaluate = [&](double offset, Eigen::VectorXd& shifted) {
    moving = at + offset;
    const bool inside = !shared || (moving >= lower()(j) && moving <= upper()(j));
    return inside && segment_residuals(column.segment, values, state, worker, shifted);
  };
  const bool forward = evaluate(step, ahead);
  const bool backward = (central || !forward) && evaluate(-step, behind);
  if (forward && backward)
    derivative = (ahead - behind) / (2.0 * step);
  else if (forward)
    derivative = (ahead - residuals) / step;
  else if (backward)
    derivative = (residuals - behind) / step;
  return forward || backward;
}

double ShootingProblem::largest_step(std::size_t kind) const {
  if (kind >= static_cast<std::size_t>(space_.size())) return 0.1;
  const auto j = static_cast<Eigen::Index>(kind);
  return space_.logarithmic(j) ? 0.1 : 0.01 * (space_.upper()(j) - space_.lower()(j));
}

std::vector<bool> ShootingProblem::adapt_steps(const std::vector<SegmentJacobian>& jacobians,
                                               const std::vector<Column>& columns, double target) {
  std::vector<double> squares(steps_.size(), 0.0), counts(steps_.size(), 0.0);
  for (const Column& column : columns) {
    const SegmentJacobian& jacobian = jacobians[column.segment];
    const Eigen::Index rows = robust_rows(column.segment);
    const auto derivative =
        is_shared(column) ? jacobian.values.col(column.index) : jacobian.state.col(column.index - space_.size());
    squares[kind(column)] += derivative.head(rows).squaredNorm();
    counts[kind(column)] += static_cast<double>(rows);
  }
  std::vector<bool> again(steps_.size(), false);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const double slope = rms(squares[i], counts[i]);
    const double wanted = std::min(slope > 0.0 ? target / slope : 1e4 * steps_[i], largest_step(i));
    again[i] = counts[i] > 0.0 && (wanted > kTolerated * steps_[i] || wanted < steps_[i] / kTolerated);
    if (again[i]) steps_[i] = std::max(wanted, 1e-12);
  }
  return again;
}

std::vector<double> residual_scales(const ShootingProblem& problem, const std::vector<Eigen::VectorXd>& residuals,
                                    const RobustLoss& loss) {
  std::vector<std::vector<double>> sizes(problem.noise().size());
  for (std::size_t k = 0; k < residuals.size(); ++k)
    for (Eigen::Index row = 0; row < problem.robust_rows(k); ++row) {
      const std::size_t channel = problem.place(k, row).channel;
      sizes[channel].push_back(std::abs(residuals[k](row)) * problem.scales()[channel]);
    }
  std::vector<double> scales;
  for (std::size_t channel = 0; channel < sizes.size(); ++channel) {
    const double scale =
        std::isfinite(loss.threshold) ? 1.4826 * median_of(sizes[channel]) : root_mean_square(sizes[channel]);
    scales.push_back(std::fmax(scale, problem.noise()[channel].deviation));  // the scale is NaN without residuals
  }
  return scales;
}

}  // namespace lacuna
