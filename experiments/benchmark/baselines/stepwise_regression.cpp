#include "baselines/stepwise_regression.h"

#include "baselines/regressors.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace hidden_effects {
namespace {

constexpr std::size_t kShapesTried = 9;  ///< shapes of an effect
constexpr std::size_t kMostChosen = 3;
constexpr double kNoRegressor = -1e9;  ///< nats
constexpr double kIndependent = 1e-4;  ///< of a column's length: less is not told apart from the others

/// Orthonormal columns that span what `columns` add to the orthonormal `basis`.
Eigen::MatrixXd added_directions(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& basis) {
  Eigen::MatrixXd own = columns;
  for (Eigen::Index i = 0; i < own.cols(); ++i) {
    const double length = own.col(i).norm();
    if (length > 0.0) own.col(i) /= length;
  }
  own -= basis * (basis.transpose() * own);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(own);
  const Eigen::ArrayXd pivots = factors.matrixQR().diagonal().cwiseAbs();
  const Eigen::Index rank = (pivots > kIndependent).count();
  Eigen::MatrixXd directions = factors.householderQ() * Eigen::MatrixXd::Identity(own.rows(), rank);
  return directions - basis * (basis.transpose() * directions);  // twice is enough for rounding
}

struct RegressorGroup {
  std::size_t candidate = 0;
  std::size_t parameters = 0;
  std::vector<Eigen::MatrixXd> shapes;  ///< weighted columns of each
};

struct Entry {
  double gain = kNoRegressor;  ///< nats
  Eigen::MatrixXd directions;
};

class Stepwise {
 public:
  Stepwise(const Observed& seen, const RecordedMotions& motions, const std::vector<Candidate>& candidates)
      : regression_(seen, motions), candidates_(candidates) {
    const Eigen::VectorXd values = regression_.fitted_base();
    const Eigen::VectorXd balance = regression_.column(seen.base, values);
    const Eigen::MatrixXd of_base = regression_.of_base(values);
    weigh(balance, of_base, seen.base.spec.joints.size());
    basis_ = added_directions(weights_.asDiagonal() * of_base, Eigen::MatrixXd(balance.size(), 0));
    residual_ = left_of(weights_.cwiseProduct(balance), basis_);
    for (std::size_t c = 0; c < candidates.size(); ++c) add_group(c, values);
  }

  BaselineAnswer run() {
    BaselineAnswer answer{"stepwise_regression", {}, 0, 0.0};
    std::vector<double> first(candidates_.size(), kNoRegressor);
    std::vector<bool> taken(candidates_.size(), false);
    for (std::size_t round = 0; round < kMostChosen; ++round) {
      std::size_t best_group = groups_.size();
      Entry best;
      for (std::size_t g = 0; g < groups_.size(); ++g) {
        if (taken[groups_[g].candidate]) continue;
        Entry entry = best_entry(groups_[g]);
        if (round == 0) first[groups_[g].candidate] = entry.gain;
        if (entry.gain > best.gain) best = std::move(entry), best_group = g;
      }
      if (!(best.gain > 0.0)) break;
      taken[groups_[best_group].candidate] = true;
      answer.ranking.push_back(ranked(candidates_[groups_[best_group].candidate], best.gain));
      ++answer.chosen;
      accept(best.directions);
    }
    append_others(answer, first, taken);
    return answer;
  }

 private:
  static Eigen::VectorXd left_of(const Eigen::VectorXd& x, const Eigen::MatrixXd& basis) {
    return x - basis * (basis.transpose() * x);
  }

  /// Rows count by what the base leaves of their joint.
  void weigh(const Eigen::VectorXd& balance, const Eigen::MatrixXd& of_base, std::size_t joints) {
    const Eigen::MatrixXd basis = added_directions(of_base, Eigen::MatrixXd(balance.size(), 0));
    const Eigen::VectorXd left = left_of(balance, basis);
    const std::vector<std::size_t> joint_of_row = regression_.joint_of_row();
    std::vector<double> squares(joints, 0.0), counts(joints, 0.0);
    for (Eigen::Index row = 0; row < left.size(); ++row) {
      squares[joint_of_row[static_cast<std::size_t>(row)]] += left[row] * left[row];
      counts[joint_of_row[static_cast<std::size_t>(row)]] += 1.0;
    }
    weights_.resize(left.size());
    for (Eigen::Index row = 0; row < left.size(); ++row) {
      const std::size_t joint = joint_of_row[static_cast<std::size_t>(row)];
      weights_[row] = std::sqrt(counts[joint] / std::max(squares[joint], std::numeric_limits<double>::min()));
    }
  }

  void add_group(std::size_t c, const Eigen::VectorXd& values) {
    if (candidates_[c].law.kind->place == Place::sensor) return;
    RegressorGroup group{c, candidates_[c].law.kind->parameters.size(), {}};
    for (const Try& tried : candidates_[c].tries(kShapesTried)) {
      const Eigen::MatrixXd columns = regression_.of_candidate(candidates_[c], tried, values);
      if (columns.size() > 0) group.shapes.push_back(weights_.asDiagonal() * columns);
    }
    if (!group.shapes.empty()) groups_.push_back(std::move(group));
  }

  Entry best_entry(const RegressorGroup& group) const {
    const double n = static_cast<double>(residual_.size()), before = residual_.squaredNorm();
    Entry best;
    for (const Eigen::MatrixXd& columns : group.shapes) {
      Eigen::MatrixXd directions = added_directions(columns, basis_);
      if (directions.cols() == 0) continue;
      const double after = before - (directions.transpose() * residual_).squaredNorm();
      const double parameters =
          static_cast<double>(std::max(static_cast<Eigen::Index>(group.parameters), directions.cols()));
      const double gain = 0.5 * n * std::log(before / std::max(after, std::numeric_limits<double>::min())) -
                          0.5 * parameters * std::log(n) - std::log(static_cast<double>(candidates_.size()));
      if (gain > best.gain) best = {gain, std::move(directions)};
    }
    return best;
  }

  void accept(const Eigen::MatrixXd& directions) {
    Eigen::MatrixXd wider(basis_.rows(), basis_.cols() + directions.cols());
    wider << basis_, directions;
    basis_ = std::move(wider);
    residual_ = left_of(residual_, basis_);
  }

  /// Those that were not taken, by what each alone would have gained.
  void append_others(BaselineAnswer& answer, const std::vector<double>& first, const std::vector<bool>& taken) const {
    std::vector<std::size_t> order(candidates_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return first[a] > first[b]; });
    for (const std::size_t c : order)
      if (!taken[c]) answer.ranking.push_back(ranked(candidates_[c], first[c]));
  }

  Regression regression_;
  const std::vector<Candidate>& candidates_;
  std::vector<RegressorGroup> groups_;
  Eigen::VectorXd weights_, residual_;
  Eigen::MatrixXd basis_;
};

}  // namespace

BaselineAnswer by_stepwise_regression(const Observed& seen, const RecordedMotions& motions,
                                      const std::vector<Candidate>& candidates) {
  return Stepwise(seen, motions, candidates).run();
}

}  // namespace hidden_effects
