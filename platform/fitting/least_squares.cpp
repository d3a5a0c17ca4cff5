#include "fitting/least_squares.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kFirstDamping = 1e-3;
constexpr double kSmallestDamping = 1e-12;
constexpr double kLargestDamping = 1e12;

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

/// A direction along which nothing changes still gets a little damping, so that it stays where it is.
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

/// The step of the shared values: values at a bound that would leave it are held, the others clipped.
Eigen::VectorXd bounded_step(const SegmentedProblem& problem, const Eigen::VectorXd& at, const Eigen::MatrixXd& matrix,
                             const Eigen::VectorXd& gradient) {
  std::vector<bool> held(static_cast<std::size_t>(at.size()), false);
  for (Eigen::Index round = 0; round <= at.size(); ++round) {
    const Eigen::VectorXd step = solve_free(matrix, gradient, held);
    bool another = false;
    for (Eigen::Index j = 0; j < at.size(); ++j) {
      const bool leaves =
          (at(j) <= problem.lower()(j) && step(j) < 0.0) || (at(j) >= problem.upper()(j) && step(j) > 0.0);
      if (leaves) held[static_cast<std::size_t>(j)] = another = true;
    }
    if (!another) return (at + step).cwiseMax(problem.lower()).cwiseMin(problem.upper()) - at;
  }
  return Eigen::VectorXd::Zero(at.size());
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

LeastSquaresResult minimize(SegmentedProblem& problem, const FitPoint& start, const LeastSquaresOptions& options) {
  LeastSquaresResult result;
  result.point = start;
  result.valid = problem.residuals(start, result.residuals);
  if (!result.valid) return result;
  result.cost = total_cost(problem, result.residuals, options.loss);

  std::vector<SegmentJacobian> jacobians;
  std::vector<Eigen::VectorXd> trial_residuals;
  double damping = kFirstDamping;
  double growth = 2.0;
  int small_steps = 0;
  while (result.iterations < options.max_iterations && !result.converged) {
    if (options.progress) options.progress(result.iterations);
    ++result.iterations;
    problem.linearize(result.point, result.residuals, jacobians);
    const NormalEquations equations = assemble(problem, result.residuals, jacobians, options.loss);

    bool accepted = false;
    while (!accepted && damping < kLargestDamping) {
      const Step step = solve(problem, equations, result.point, damping);
      // Nothing left to gain is the end, whatever the damping.
      if (!(step.predicted > 0.01 * options.tolerance * result.cost)) break;
      const FitPoint next = moved(result.point, step);
      const double cost = problem.residuals(next, trial_residuals) ? total_cost(problem, trial_residuals, options.loss)
                                                                   : std::numeric_limits<double>::infinity();
      if (cost < result.cost) {
        accepted = true;
        // Under heavy damping a short step alone proves nothing; two in a row do.
        small_steps = result.cost - cost < options.tolerance * result.cost ? small_steps + 1 : 0;
        result.converged = small_steps > 1 || (small_steps == 1 && damping < 1.0);
        const double ratio = (result.cost - cost) / step.predicted;
        damping = std::max(damping * std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * ratio - 1.0, 3)), kSmallestDamping);
        growth = 2.0;
        result.point = next;
        result.cost = cost;
        std::swap(result.residuals, trial_residuals);
      } else {
        damping *= growth;
        growth *= 2.0;
      }
    }
    if (!accepted) result.converged = true;
  }
  return result;
}

}  // namespace lacuna
