#include "criterion/cost.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lacuna {
namespace {

constexpr int kRounds = 12;
constexpr double kSettled = 1e-6;  ///< of the longest step

/// Readings of a cell in all blocks.
double samples_of(const CellLayout& layout, const BlockProducts& products, std::size_t cell) {
  double sum = 0.0;
  for (std::size_t b = 0; b < layout.blocks(); ++b) sum += products.samples(cell, b);
  return sum;
}

double quadratic(const Eigen::Ref<const Eigen::MatrixXd>& product, const Eigen::VectorXd& step) {
  const Eigen::Index n = step.size();
  return product(0, 0) - 2.0 * product.col(0).tail(n).dot(step) + step.dot(product.bottomRightCorner(n, n) * step);
}

/// Products of each cell, summed over all blocks.
std::vector<Eigen::MatrixXd> sums_over_blocks(const CellLayout& layout, const BlockProducts& products) {
  const Eigen::Index size = products.values() + 1;
  std::vector<Eigen::MatrixXd> sums(layout.cells.size(), Eigen::MatrixXd::Zero(size, size));
  for (std::size_t c = 0; c < layout.cells.size(); ++c)
    for (std::size_t b = 0; b < layout.blocks(); ++b) sums[c] += products.at(c, b);
  return sums;
}

/// Σ weight × product over cells.
Eigen::MatrixXd weighted_sum(const std::vector<Eigen::MatrixXd>& sums, const Eigen::VectorXd& weights,
                             Eigen::Index values) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(values + 1, values + 1);
  for (std::size_t c = 0; c < sums.size(); ++c)
    if (const double weight = weights(static_cast<Eigen::Index>(c)); weight > 0.0) sum += weight * sums[c];
  return sum;
}

/// By fold, Σ weight × product over cells and the blocks of this fold.
std::vector<Eigen::MatrixXd> weighted_folds(const CellLayout& layout, const BlockProducts& products,
                                            const Eigen::VectorXd& weights) {
  const Eigen::Index size = products.values() + 1;
  std::vector<Eigen::MatrixXd> folds(layout.folds, Eigen::MatrixXd::Zero(size, size));
  for (std::size_t c = 0; c < layout.cells.size(); ++c)
    for (std::size_t b = 0; b < layout.blocks(); ++b)
      folds[layout.fold_of_block[b]] += weights(static_cast<Eigen::Index>(c)) * products.at(c, b);
  return folds;
}

/// The cost of a step by what `sums_over_blocks` has.
LinearCost cost_of_sums(const CellLayout& layout, const BlockProducts& products,
                        const std::vector<Eigen::MatrixXd>& sums, const Eigen::VectorXd& step) {
  LinearCost result{step, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(layout.cells.size())), 0.0};
  for (std::size_t c = 0; c < layout.cells.size(); ++c) {
    const double samples = samples_of(layout, products, c);
    if (samples == 0.0) continue;
    const double mean = std::max(0.0, quadratic(sums[c], step) / samples);
    result.mean_square(static_cast<Eigen::Index>(c)) = mean;
    result.cost += layout.cells[c].weight * cost_of_mean_square(mean);
  }
  return result;
}

/// The solution in the directions that the matrix, symmetric and scaled, tells; in the others the way home.
Eigen::VectorXd told_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                              const Eigen::VectorXd& home) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix);
  const Eigen::VectorXd& values = eigen.eigenvalues();
  Eigen::VectorXd along = eigen.eigenvectors().transpose() * right;
  const Eigen::VectorXd way_home = eigen.eigenvectors().transpose() * home;
  for (Eigen::Index i = 0; i < along.size(); ++i)
    along(i) = values(i) > kUntold * values.maxCoeff() ? along(i) / values(i) : way_home(i);
  return eigen.eigenvectors() * along;
}

/// Least squares within bounds, by an active set: values that leave their bounds are held there, and one that the
/// others' values make go back inside is freed again (P. B. Stark and R. L. Parker, Computational Statistics 10, 1995,
/// 129-141). Values that the data do not tell go home, or stay.
class BoundedStep {
 public:
  BoundedStep(Eigen::MatrixXd normal, const StepBounds& bounds, double damping) {
    const Eigen::Index n = normal.rows() - 1;
    home_ = Eigen::VectorXd::Zero(n);
    if (bounds.home.size() == n) {
      home_ = bounds.home;
      normal.diagonal().tail(n) += 2.0 * bounds.pull;
      normal.col(0).tail(n) += 2.0 * bounds.pull.cwiseProduct(home_);
    }
    scale_ = normal.diagonal().tail(n).cwiseMax(1e-300).cwiseSqrt();
    matrix_ = scale_.cwiseInverse().asDiagonal() * normal.bottomRightCorner(n, n) * scale_.cwiseInverse().asDiagonal();
    matrix_.diagonal().array() += damping;
    if (bounds.ridge.size() == n) matrix_.diagonal() += bounds.ridge;
    right_ = normal.col(0).tail(n).cwiseQuotient(scale_);
    lower_ = bounds.lower.cwiseProduct(scale_);
    upper_ = bounds.upper.cwiseProduct(scale_);
    home_ = home_.cwiseProduct(scale_);
  }

  Eigen::VectorXd step() const {
    const Eigen::Index n = right_.size();
    Places moving;
    for (Eigen::Index i = 0; i < n; ++i) moving.push_back(i);
    Eigen::VectorXd best = settled(moving, Eigen::VectorXd::Zero(n));
    for (Eigen::Index round = 0; round < n; ++round) {
      const Eigen::Index freed = most_held_back(moving, best);
      if (freed < 0) break;
      moving.push_back(freed);
      const Eigen::VectorXd step = settled(moving, best);
      if (cost_of(step) >= cost_of(best) - kLess * std::abs(cost_of(best))) break;
      best = step;
    }
    return best.cwiseQuotient(scale_);
  }

 private:
  using Places = std::vector<Eigen::Index>;
  static constexpr double kLess = 1e-12;

  double cost_of(const Eigen::VectorXd& step) const { return 0.5 * step.dot(matrix_ * step) - right_.dot(step); }

  /// The least cost by the values that move, the others as in `step`. Those that leave their bounds stay there and move
  /// no longer.
  Eigen::VectorXd settled(Places& moving, Eigen::VectorXd step) const {
    while (!moving.empty()) {
      for (const Eigen::Index i : moving) step(i) = 0.0;
      const Eigen::VectorXd rest = right_ - matrix_ * step;
      const Eigen::VectorXd found = told_solution(matrix_(moving, moving), rest(moving), home_(moving));
      Places inside;
      for (std::size_t i = 0; i < moving.size(); ++i) {
        const Eigen::Index j = moving[i];
        const double wanted = found(static_cast<Eigen::Index>(i));
        step(j) = std::clamp(wanted, lower_(j), upper_(j));
        if (step(j) == wanted) inside.push_back(j);
      }
      if (inside.size() == moving.size()) break;
      moving = std::move(inside);
    }
    return step;
  }

  /// Of the values that are held at a bound, the one whose way back inside lowers the cost fastest; -1: none.
  Eigen::Index most_held_back(const Places& moving, const Eigen::VectorXd& step) const {
    const Eigen::VectorXd slope = right_ - matrix_ * step;
    Eigen::Index found = -1;
    double fastest = kLess;
    for (Eigen::Index j = 0; j < step.size(); ++j) {
      if (std::find(moving.begin(), moving.end(), j) != moving.end() || !(lower_(j) < upper_(j))) continue;
      const double inward = step(j) <= lower_(j) ? slope(j) : -slope(j);
      if (inward > fastest) {
        fastest = inward;
        found = j;
      }
    }
    return found;
  }

  Eigen::MatrixXd matrix_;
  Eigen::VectorXd right_, scale_, lower_, upper_, home_;
};

/// Of the whole data's normal equations, that every fold's others get: a value that they hardly tell does not run away.
constexpr double kOfAll = 0.1;

}  // namespace

Eigen::VectorXd square_weights(const CellLayout& layout, const BlockProducts& products, const Eigen::VectorXd& means) {
  Eigen::VectorXd weights(means.size());
  for (std::size_t c = 0; c < layout.cells.size(); ++c) {
    const double samples = samples_of(layout, products, c);
    const auto i = static_cast<Eigen::Index>(c);
    weights(i) = samples > 0.0 ? layout.cells[c].weight / (samples * std::max(1.0, means(i))) : 0.0;
  }
  return weights;
}

double cost_of_mean_square(double mean_square) {
  return mean_square > 1.0 ? 0.5 * std::log(mean_square) : 0.5 * (mean_square - 1.0);
}

LinearCost cost_at(const CellLayout& layout, const BlockProducts& products, const Eigen::VectorXd& step) {
  return cost_of_sums(layout, products, sums_over_blocks(layout, products), step);
}

LinearCost least_cost(const CellLayout& layout, const BlockProducts& products, const StepBounds& bounds,
                      double damping) {
  const std::vector<Eigen::MatrixXd> sums = sums_over_blocks(layout, products);
  LinearCost best = cost_of_sums(layout, products, sums, Eigen::VectorXd::Zero(products.values()));
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::VectorXd weights = square_weights(layout, products, best.mean_square);
    const Eigen::VectorXd step = BoundedStep(weighted_sum(sums, weights, products.values()), bounds, damping).step();
    const LinearCost next = cost_of_sums(layout, products, sums, step);
    if (!(next.cost + bounds.cost_of_way(next.step) < best.cost + bounds.cost_of_way(best.step))) break;
    const bool is_settled = (step - best.step).lpNorm<Eigen::Infinity>() <= kSettled * step.lpNorm<Eigen::Infinity>();
    best = next;
    if (is_settled) break;
  }
  return best;
}

CrossFittedCost cross_fit(const CellLayout& layout, const BlockProducts& products, const StepBounds& bounds,
                          const LinearCost& fit, bool whole_steps) {
  const Eigen::VectorXd weights = square_weights(layout, products, fit.mean_square);
  const std::vector<Eigen::MatrixXd> folds = weighted_folds(layout, products, weights);
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(products.values() + 1, products.values() + 1);
  for (const Eigen::MatrixXd& fold : folds) all += fold;
  Eigen::VectorXd from = Eigen::VectorXd::Zero(products.values());
  if (!whole_steps) from = BoundedStep(all, bounds, 0.0).step();
  const double of_all = whole_steps ? 0.0 : kOfAll;
  std::vector<Eigen::VectorXd> steps;
  for (std::size_t fold = 0; fold < layout.folds; ++fold) {
    Eigen::MatrixXd others = of_all * all;
    for (std::size_t other = 0; other < layout.folds; ++other)
      if (other != fold) others += folds[other];
    steps.push_back(BoundedStep(std::move(others), bounds, 0.0).step() - from);
  }
  CrossFittedCost result;
  result.by_length =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(layout.lengths), static_cast<Eigen::Index>(layout.blocks()));
  for (std::size_t c = 0; c < layout.cells.size(); ++c) {
    const double samples = samples_of(layout, products, c);
    if (samples == 0.0) continue;
    Eigen::VectorXd squares(static_cast<Eigen::Index>(layout.blocks()));
    for (std::size_t b = 0; b < layout.blocks(); ++b)
      squares(static_cast<Eigen::Index>(b)) = quadratic(products.at(c, b), steps[layout.fold_of_block[b]]);
    const double scale = std::max(1.0, squares.sum() / samples);
    for (std::size_t b = 0; b < layout.blocks(); ++b) {
      const auto i = static_cast<Eigen::Index>(b);
      result.by_length(static_cast<Eigen::Index>(layout.cells[c].length), i) +=
          0.5 * layout.cells[c].weight / samples *
          (products.samples(c, b) * (std::log(scale) - 1.0) + squares(i) / scale);
    }
  }
  result.cost = result.by_length.sum();
  return result;
}

Eigen::MatrixXd information(const CellLayout& layout, const BlockProducts& products, const LinearCost& fit) {
  const Eigen::MatrixXd sum = weighted_sum(sums_over_blocks(layout, products),
                                           square_weights(layout, products, fit.mean_square), products.values());
  return sum.bottomRightCorner(products.values(), products.values());
}

int told_values(const Eigen::MatrixXd& information) {
  const Eigen::Index n = information.rows();
  if (n == 0) return 0;
  const Eigen::VectorXd scale = information.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues();
  return static_cast<int>((eigenvalues.array() > kUntold * eigenvalues.maxCoeff()).count());
}

}  // namespace lacuna
