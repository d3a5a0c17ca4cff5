#include "fitting/numerics/least_squares.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kFirstDamping = 1e-3;
constexpr double kSmallestDamping = 1e-12;
constexpr double kLargestDamping = 1e12;
constexpr double kGoodEnough = 0.25;  ///< of the predicted decrease: after such a step derivatives may be updated

/// Normal equations of one segment's own unknowns.
struct StateEquations {
  Eigen::MatrixXd hessian;  ///< of the state
  Eigen::MatrixXd mixed;    ///< state × shared values
  Eigen::VectorXd gradient;
};

struct NormalEquations {
  Eigen::MatrixXd hessian;  ///< of the shared values
  Eigen::VectorXd gradient;
  std::vector<StateEquations> segments;
};

struct Step {
  Eigen::VectorXd values;
  std::vector<Eigen::VectorXd> states;
  double predicted = 0.0;  ///< decrease of the cost by the quadratic model
};

Eigen::VectorXd weights_of(const SegmentedProblem& problem, std::size_t k, const Eigen::VectorXd& residuals,
                           const RobustLoss& loss) {
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(residuals.size());
  for (Eigen::Index row = 0; row < problem.robust_rows(k); ++row) weights(row) = loss.weight(residuals(row));
  return weights;
}

NormalEquations assemble(const SegmentedProblem& problem, const std::vector<Eigen::VectorXd>& residuals,
                         const std::vector<SegmentJacobian>& jacobians, const RobustLoss& loss) {
  NormalEquations equations;
  const Eigen::Index size = problem.lower().size();
  equations.hessian = Eigen::MatrixXd::Zero(size, size);
  equations.gradient = Eigen::VectorXd::Zero(size);
  for (std::size_t k = 0; k < residuals.size(); ++k) {
    const Eigen::VectorXd weights = weights_of(problem, k, residuals[k], loss);
    const Eigen::MatrixXd weighted_values = weights.asDiagonal() * jacobians[k].values;
    const Eigen::MatrixXd weighted_state = weights.asDiagonal() * jacobians[k].state;
    equations.hessian += weighted_values.transpose() * jacobians[k].values;
    equations.gradient += weighted_values.transpose() * residuals[k];
    equations.segments.push_back({weighted_state.transpose() * jacobians[k].state,
                                  weighted_state.transpose() * jacobians[k].values,
                                  weighted_state.transpose() * residuals[k]});
  }
  return equations;
}

/// A direction without influence gets a little damping, so that it stays.
Eigen::MatrixXd damped(const Eigen::MatrixXd& hessian, double damping) {
  Eigen::MatrixXd result = hessian;
  const double least = std::max(1e-14 * (hessian.size() > 0 ? hessian.diagonal().maxCoeff() : 0.0), 1e-300);
  result.diagonal() += damping * hessian.diagonal().cwiseMax(least);
  result.diagonal() = result.diagonal().cwiseMax(least);
  return result;
}

/// Solves the reduced equations for the shared values that are not held.
Eigen::VectorXd solve_free(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& gradient,
                           const std::vector<bool>& held) {
  std::vector<Eigen::Index> free;
  for (Eigen::Index j = 0; j < gradient.size(); ++j)
    if (!held[static_cast<std::size_t>(j)]) free.push_back(j);
  Eigen::VectorXd step = Eigen::VectorXd::Zero(gradient.size());
  if (free.empty()) return step;
  // Unit diagonal first: values differ by many orders of magnitude.
  const Eigen::MatrixXd part = matrix(free, free);
  const Eigen::VectorXd scale = part.diagonal().cwiseAbs().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * part * scale.asDiagonal();
  const Eigen::VectorXd right = -scale.cwiseProduct(gradient(free));
  step(free) = scale.cwiseProduct(scaled.ldlt().solve(right));
  return step;
}

/// The step of the shared values inside their bounds: a value that would leave them goes to its bound, and the others
/// to their optimum beside it.
Eigen::VectorXd bounded_step(const SegmentedProblem& problem, const Eigen::VectorXd& at, const Eigen::MatrixXd& matrix,
                             const Eigen::VectorXd& gradient) {
  std::vector<bool> held(static_cast<std::size_t>(at.size()), false);
  Eigen::VectorXd to_bounds = Eigen::VectorXd::Zero(at.size());
  for (Eigen::Index round = 0; round <= at.size(); ++round) {
    Eigen::VectorXd step = to_bounds + solve_free(matrix, gradient + matrix * to_bounds, held);
    bool another = false;
    for (Eigen::Index j = 0; j < at.size(); ++j) {
      const double to = at(j) + step(j), lower = problem.lower()(j), upper = problem.upper()(j);
      if (held[static_cast<std::size_t>(j)] || (to >= lower && to <= upper)) continue;
      to_bounds(j) = std::clamp(to, lower, upper) - at(j);
      held[static_cast<std::size_t>(j)] = another = true;
    }
    if (!another) return step;
  }
  return to_bounds;
}

double predicted_decrease(const NormalEquations& equations, const Step& step) {
  double decrease = -2.0 * equations.gradient.dot(step.values) - step.values.dot(equations.hessian * step.values);
  for (std::size_t k = 0; k < step.states.size(); ++k) {
    const StateEquations& segment = equations.segments[k];
    const Eigen::VectorXd& state = step.states[k];
    decrease -= 2.0 * segment.gradient.dot(state) + state.dot(segment.hessian * state) +
                2.0 * state.dot(segment.mixed * step.values);
  }
  return decrease;
}

Step solve(const SegmentedProblem& problem, const NormalEquations& equations, const FitPoint& point, double damping) {
  Eigen::MatrixXd reduced = damped(equations.hessian, damping);
  Eigen::VectorXd gradient = equations.gradient;
  std::vector<Eigen::LDLT<Eigen::MatrixXd>> factors;
  for (const StateEquations& segment : equations.segments) {
    factors.emplace_back(damped(segment.hessian, damping));
    if (segment.gradient.size() == 0 || gradient.size() == 0) continue;
    reduced -= segment.mixed.transpose() * factors.back().solve(segment.mixed);
    gradient -= segment.mixed.transpose() * factors.back().solve(segment.gradient);
  }
  Step step;
  step.values = bounded_step(problem, point.values, reduced, gradient);
  for (std::size_t k = 0; k < equations.segments.size(); ++k) {
    const StateEquations& segment = equations.segments[k];
    step.states.push_back(segment.gradient.size() == 0
                              ? Eigen::VectorXd()
                              : Eigen::VectorXd(-factors[k].solve(segment.gradient + segment.mixed * step.values)));
  }
  step.predicted = predicted_decrease(equations, step);
  return step;
}

FitPoint moved(const FitPoint& point, const Step& step) {
  FitPoint next = point;
  next.values += step.values;
  for (std::size_t k = 0; k < next.states.size(); ++k) next.states[k] += step.states[k];
  return next;
}

}  // namespace

double total_cost(const SegmentedProblem& problem, const std::vector<Eigen::VectorXd>& residuals,
                  const RobustLoss& loss) {
  double sum = 0.0;
  for (std::size_t k = 0; k < residuals.size(); ++k)
    for (Eigen::Index row = 0; row < residuals[k].size(); ++row) {
      const double r = residuals[k](row);
      sum += row < problem.robust_rows(k) ? loss.cost(r) : r * r;
    }
  return sum;
}

namespace {

/// Broyden's update: the smallest change of a segment's derivatives that agrees with the last step. Unknowns are scaled
/// by their influence on the residuals.
void follow(const Step& step, std::size_t k, const Eigen::VectorXd& change, SegmentJacobian& jacobian) {
  const Eigen::VectorXd& values = step.values;
  const Eigen::VectorXd& state = step.states[k];
  const Eigen::VectorXd missed = change - jacobian.values * values - jacobian.state * state;
  const Eigen::VectorXd by_values = jacobian.values.colwise().squaredNorm().transpose().cwiseProduct(values);
  const Eigen::VectorXd by_state = jacobian.state.colwise().squaredNorm().transpose().cwiseProduct(state);
  const double size = by_values.dot(values) + by_state.dot(state);
  if (!(size > 0.0)) return;
  jacobian.values += missed * (by_values / size).transpose();
  jacobian.state += missed * (by_state / size).transpose();
}

class Descent {
 public:
  Descent(SegmentedProblem& problem, const FitPoint& start, const LeastSquaresOptions& options)
      : problem_(problem), options_(options) {
    result_.point = start;
    result_.valid = problem.residuals(start, result_.residuals);
    if (result_.valid) result_.cost = total_cost(problem, result_.residuals, options.loss);
  }

  LeastSquaresResult run() {
    while (result_.valid && !result_.converged) {
      if (follows_ == 0) {
        if (result_.iterations == options_.max_iterations) break;
        linearize();
      }
      const bool exact = follows_ == 0;
      const bool stepped = step();
      if (!exact && (!stepped || result_.converged)) {  // updated derivatives cannot decide on convergence
        result_.converged = at_point_ = false;
        follows_ = 0;
      } else if (!stepped) {
        result_.converged = true;
      }
    }
    if (!at_point_) result_.jacobians.clear();
    return std::move(result_);
  }

 private:
  void linearize() {
    if (options_.progress) options_.progress(result_.iterations);
    ++result_.iterations;
    problem_.linearize(result_.point, result_.residuals, result_.jacobians);
    at_point_ = true;
  }

  /// Moves to a better point, if one is worth it.
  bool step() {
    const NormalEquations equations = assemble(problem_, result_.residuals, result_.jacobians, options_.loss);
    while (damping_ < kLargestDamping) {
      const Step step = solve(problem_, equations, result_.point, damping_);
      if (step.predicted < 0.0 && follows_ == 0) {  // bounds can turn a long step uphill; a short one follows the slope
        damp_more();
        continue;
      }
      // With nothing left to gain the search ends, whatever the damping.
      if (!(step.predicted > 0.01 * options_.tolerance * result_.cost)) return false;
      const FitPoint next = moved(result_.point, step);
      const double cost = problem_.residuals(next, trial_residuals_)
                              ? total_cost(problem_, trial_residuals_, options_.loss)
                              : std::numeric_limits<double>::infinity();
      if (cost < result_.cost) {
        take(step, next, cost);
        return true;
      }
      if (follows_ > 0) return false;
      damp_more();
    }
    return false;
  }

  void damp_more() {
    damping_ *= growth_;
    growth_ *= 2.0;
  }

  void take(const Step& step, const FitPoint& next, double cost) {
    const double gained = result_.cost - cost, ratio = gained / step.predicted;
    // Under heavy damping a short step alone proves nothing; two in a row do.
    small_steps_ = gained < options_.tolerance * result_.cost ? small_steps_ + 1 : 0;
    result_.converged = small_steps_ > 1 || (small_steps_ == 1 && damping_ < 1.0);
    damping_ = std::max(damping_ * std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * ratio - 1.0, 3)), kSmallestDamping);
    growth_ = 2.0;
    follows_ = options_.secants && ratio > kGoodEnough && !result_.converged ? follows_ + 1 : 0;
    for (std::size_t k = 0; follows_ > 0 && k < result_.jacobians.size(); ++k)
      follow(step, k, trial_residuals_[k] - result_.residuals[k], result_.jacobians[k]);
    at_point_ = result_.converged;
    result_.point = next;
    result_.cost = cost;
    std::swap(result_.residuals, trial_residuals_);
    if (options_.reached) options_.reached(result_.point);
  }

  SegmentedProblem& problem_;
  const LeastSquaresOptions& options_;
  LeastSquaresResult result_;
  std::vector<Eigen::VectorXd> trial_residuals_;
  double damping_ = kFirstDamping, growth_ = 2.0;
  int small_steps_ = 0;
  int follows_ = 0;        ///< number of steps since the derivatives were computed
  bool at_point_ = false;  ///< they were computed at this point, or within the tolerance of it
};

}  // namespace

LeastSquaresResult minimize(SegmentedProblem& problem, const FitPoint& start, const LeastSquaresOptions& options) {
  return Descent(problem, start, options).run();
}

}  // namespace lacuna
