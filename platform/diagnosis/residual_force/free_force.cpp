#include "diagnosis/residual_force/free_force.h"

#include "diagnosis/noise/last_digits.h"
#include "diagnosis/refit/cross_validation.h"
#include "diagnosis/residual_force/force_interaction.h"
#include "diagnosis/residual_force/force_regression.h"
#include "diagnosis/screening/screening.h"
#include "fitting/seeded_noise.h"
#include "kernels/dense.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace lacuna {
namespace {

constexpr int kPositions = 14, kVelocities = 15, kCommands = 7;  // functions of each
constexpr std::array kSlices = {0.03, 0.5, 0.97};  // of the positions, at which the force is drawn against velocity ...
constexpr int kSliceKnots = 9;                     // ... at so many velocities
constexpr double kNear = 0.1, kSeen = 0.05;        // of the range of positions; of the velocities there
constexpr double kRounding = 1e-6;                 // of the strongest direction
constexpr std::array kRidges = {0.001, 0.01, 0.1, 1.0, 10.0, 100.0, 1000.0};
constexpr double kPiece = 0.5;  ///< s, the shortest blocks that noise pushes either way are no longer
constexpr Eigen::Index kFewestBlocks = 16;
constexpr int kMostChoices = 3;  // of a ridge, each with the weights of the fit before

/// One of the quantities that a joint's force may follow.
struct Regressor {
  std::string name, unit;
  int functions = 0;
  const std::vector<Eigen::VectorXd>& values;  ///< by segment, a value a pulse
};

std::vector<Regressor> regressors(const JointMotion& motion) {
  std::vector<Regressor> all = {{"position", motion.position_unit, kPositions, motion.position},
                                {"velocity", motion.position_unit + "/s", kVelocities, motion.velocity}};
  if (!motion.command.empty()) all.push_back({"command", motion.command_unit, kCommands, motion.command});
  return all;
}

std::vector<double> all_of(const std::vector<Eigen::VectorXd>& values) {
  std::vector<double> all;
  for (const Eigen::VectorXd& one : values) all.insert(all.end(), one.begin(), one.end());
  return all;
}

/// The value that `share` of them stay below; NaN of none.
double quantile(std::vector<double> all, double share) {
  if (all.empty()) return std::nan("");
  std::sort(all.begin(), all.end());
  return all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))];
}

/// Knots at quantiles, so that each function sees as much data.
std::vector<double> knots(const Regressor& regressor) {
  const std::vector<double> all = all_of(regressor.values);
  std::vector<double> chosen;
  for (int i = 0; i < regressor.functions; ++i) {
    const double knot = quantile(all, static_cast<double>(i) / (regressor.functions - 1));
    if (chosen.empty() || knot > chosen.back()) chosen.push_back(knot);
  }
  return chosen;
}

/// The piecewise linear function that is 1 at knot `i` and 0 at its neighbours.
double hat(const std::vector<double>& at, std::size_t i, double x) {
  if (i > 0 && x < at[i]) return std::max(0.0, (x - at[i - 1]) / (at[i] - at[i - 1]));
  if (i + 1 < at.size() && x > at[i]) return std::max(0.0, (at[i + 1] - x) / (at[i + 1] - at[i]));
  return 1.0;
}

/// Combinations of whitened columns that can be seen, strongest first: columns × combinations.
Eigen::MatrixXd independent(const Eigen::MatrixXd& columns) {
  const Eigen::VectorXd unit =
      columns.colwise().norm().unaryExpr([](double norm) { return norm > 0.0 ? 1.0 / norm : 0.0; });
  const dense::Eigenvectors eigen(unit.asDiagonal() * dense::square(columns.transpose()) * unit.asDiagonal());
  const double least = kRounding * std::max(eigen.values.maxCoeff(), 1e-300);
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = eigen.values.size() - 1; i >= 0; --i)
    if (eigen.values(i) > least) kept.push_back(i);
  return unit.asDiagonal() * Eigen::MatrixXd(eigen.vectors(Eigen::all, kept));
}

/// The force where `readings` say, and its standard errors; of a fit of combinations.
void draw_curves(const Eigen::MatrixXd& readings, const Eigen::VectorXd& sizes, const Eigen::MatrixXd& covariance,
                 std::vector<ForceCurve>& curves) {
  const Eigen::VectorXd force = readings * sizes;
  const Eigen::VectorXd variance = (readings * covariance).cwiseProduct(readings).rowwise().sum();
  Eigen::Index row = 0;
  for (ForceCurve& curve : curves)
    for (std::size_t i = 0; i < curve.at.size(); ++i, ++row) {
      curve.force.push_back(force(row));
      curve.standard_error.push_back(std::sqrt(std::max(0.0, variance(row))));
    }
}

/// What each piece of the segments contributes to the score of every column, columns made orthonormal: columns ×
/// pieces, as many of a segment as `pieces` says, one after the other in time.
Eigen::MatrixXd scores_of(const WhitenedSegments& whitened, const Eigen::MatrixXd& columns,
                          const std::vector<Eigen::Index>& pieces) {
  Eigen::MatrixXd scores(columns.cols(), std::accumulate(pieces.begin(), pieces.end(), Eigen::Index{0}));
  Eigen::Index column = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Eigen::Index begin = whitened.first(k), all = whitened.first(k + 1) - begin;
    for (Eigen::Index piece = 0; piece < pieces[k]; ++piece) {
      const Eigen::Index first = begin + all * piece / pieces[k], rows = begin + all * (piece + 1) / pieces[k] - first;
      scores.col(column++) = columns.middleRows(first, rows).transpose() * whitened.residual().segment(first, rows);
    }
  }
  dense::Cholesky(dense::square(columns.transpose())).solve_lower(scores);
  return scores;
}

/// Scores of blocks of so many pieces, one after the other.
Eigen::MatrixXd in_blocks(const Eigen::MatrixXd& scores, Eigen::Index length) {
  Eigen::MatrixXd blocks = Eigen::MatrixXd::Zero(scores.rows(), (scores.cols() + length - 1) / length);
  for (Eigen::Index k = 0; k < scores.cols(); ++k) blocks.col(k / length) += scores.col(k);
  return blocks;
}

/// Of a deviance, of one that is more, and of one that is less by what last digits may do.
using Chances = std::array<double, 3>;

/// How often the deviance is reached when the signs of the blocks' scores are drawn. Noise, whatever its spectrum,
/// pushes a block one way as often as the other; a force that follows the motion does not.
Chances p_by_signs(const Eigen::MatrixXd& blocks, double deviance, std::uint64_t seed) {
  SeededNoise random(seed, 0xf2ee);
  Eigen::MatrixXd signs(blocks.cols(), static_cast<Eigen::Index>(kNullDraws));
  for (double& sign : signs.reshaped()) sign = random.uniform() < 0.5 ? -1.0 : 1.0;
  const Eigen::RowVectorXd drawn = dense::product(blocks, signs).colwise().squaredNorm();
  const auto p = [&](double size) {
    return (1.0 + static_cast<double>((drawn.array() >= size).count())) / (1.0 + kNullDraws);
  };
  return {p(deviance), p(deviance * (1.0 + kLastDigitsOfScore)), p(deviance * (1.0 - kLastDigitsOfScore))};
}

/// The largest of all lengths of blocks that leave enough of them: how long a slow random force lasts is not known.
Chances p_by_chance(const Eigen::MatrixXd& scores, double deviance, std::uint64_t seed) {
  Chances p = p_by_signs(scores, deviance, seed);
  for (Eigen::Index length = 2; scores.cols() >= length * kFewestBlocks; length *= 2) {
    const Chances other = p_by_signs(in_blocks(scores, length), deviance, seed);
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = std::max(p[i], other[i]);
  }
  return p;
}

double best_ridge(const ForceRegression& regression, const ForceRegression::Columns& all) {
  double least = INFINITY, best = kRidges.front();
  for (const double ridge : kRidges) {
    const double deviance = regression.held_out(all, ridge).sum();
    if (!(deviance < least)) continue;
    least = deviance;
    best = ridge;
  }
  return best;
}

/// The functions of one joint.
class JointForce {
 public:
  explicit JointForce(const JointMotion& motion) : motion_(motion), interaction_(motion) {
    for (Regressor& one : regressors(motion)) {
      std::vector<double> at = knots(one);
      if (at.size() < 3) continue;
      parts_.push_back({std::move(one), std::move(at), count_});
      count_ += static_cast<Eigen::Index>(parts_.back().at.size());
    }
    if (!parts_.empty()) count_ += ForceInteraction::kCount;
  }

  Eigen::Index count() const { return count_; }

  /// At every pulse of a segment: pulses × functions.
  Eigen::MatrixXd at_pulses(std::size_t segment) const {
    const Eigen::Index pulses = motion_.position[segment].size();
    Eigen::MatrixXd values(pulses, count_);
    for (const Part& part : parts_)
      for (Eigen::Index p = 0; p < pulses; ++p) put(part, part.of.values[segment](p), values.row(p));
    for (Eigen::Index p = 0; p < pulses && !parts_.empty(); ++p)
      values.row(p).tail<ForceInteraction::kCount>() =
          interaction_.at(motion_.position[segment](p), motion_.velocity[segment](p)).transpose();
    return values;
  }

  /// The curve of each quantity, then the force against velocity at a few positions; `readings` gets rows of functions.
  void add_curves(std::vector<ForceCurve>& curves, std::vector<Eigen::VectorXd>& readings) const {
    for (const Part& part : parts_) {
      curves.push_back({motion_.joint, part.of.name, part.of.unit, motion_.force_unit, part.at, {}, {}});
      for (std::size_t i = 0; i < part.at.size(); ++i)
        readings.push_back(Eigen::VectorXd::Unit(count_, part.first + static_cast<Eigen::Index>(i)));
    }
    if (parts_.empty()) return;
    for (const double share : kSlices) add_slice(quantile(all_of(motion_.position), share), curves, readings);
  }

 private:
  struct Part {
    Regressor of;
    std::vector<double> at;  ///< knots
    Eigen::Index first = 0;  ///< function
  };

  template <class Row>
  static void put(const Part& part, double value, Row&& row) {
    for (std::size_t i = 0; i < part.at.size(); ++i)
      row(part.first + static_cast<Eigen::Index>(i)) = hat(part.at, i, value);
  }

  /// Only where the joint was as fast near that position.
  void add_slice(double position, std::vector<ForceCurve>& curves, std::vector<Eigen::VectorXd>& readings) const {
    const std::vector<double> positions = all_of(motion_.position), velocities = all_of(motion_.velocity);
    const double near = kNear * (quantile(positions, 1.0) - quantile(positions, 0.0));
    std::vector<double> seen;
    for (std::size_t i = 0; i < positions.size(); ++i)
      if (std::abs(positions[i] - position) <= near) seen.push_back(velocities[i]);
    const double low = quantile(seen, kSeen), high = quantile(seen, 1.0 - kSeen);
    if (!(low < high)) return;
    ForceCurve slice{motion_.joint, "velocity", motion_.position_unit + "/s", motion_.force_unit, {}, {}, {}, position};
    for (int i = 0; i < kSliceKnots; ++i) {
      const double velocity = std::lerp(low, high, static_cast<double>(i) / (kSliceKnots - 1));
      Eigen::VectorXd row = Eigen::VectorXd::Zero(count_);
      for (const Part& part : parts_) {
        if (part.of.name == "position") put(part, position, row);
        if (part.of.name == "velocity") put(part, velocity, row);
      }
      row.tail<ForceInteraction::kCount>() = interaction_.at(position, velocity);
      slice.at.push_back(velocity);
      readings.push_back(std::move(row));
    }
    curves.push_back(std::move(slice));
  }

  const JointMotion& motion_;
  ForceInteraction interaction_;
  std::vector<Part> parts_;
  Eigen::Index count_ = 0;
};

}  // namespace

FreeForce free_force(const std::vector<JointMotion>& motions, const ForceResponses& forces) {
  FreeForce force;
  std::vector<JointForce> joints(motions.begin(), motions.end());
  Eigen::Index functions = 0;
  for (const JointForce& joint : joints) functions += joint.count();
  std::vector<Eigen::VectorXd> rows;
  Eigen::Index first = 0;
  for (const JointForce& joint : joints) {
    std::vector<Eigen::VectorXd> own;
    joint.add_curves(force.curves, own);
    for (const Eigen::VectorXd& one : own) {
      rows.push_back(Eigen::VectorXd::Zero(functions));
      rows.back().segment(first, joint.count()) = one;
    }
    first += joint.count();
  }
  for (const Eigen::VectorXd& times : forces.times)
    force.pieces.push_back(
        static_cast<Eigen::Index>(std::ceil(forces.width * static_cast<double>(times.size()) / kPiece - 1e-6)));
  force.readings.resize(static_cast<Eigen::Index>(rows.size()), functions);
  for (std::size_t i = 0; i < rows.size(); ++i) force.readings.row(static_cast<Eigen::Index>(i)) = rows[i];
  for (std::size_t k = 0; k < forces.of.size() && !force.empty(); ++k) {
    Eigen::MatrixXd all(forces.of[k].front().rows(), functions);
    first = 0;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      all.middleCols(first, joints[j].count()) = forces.of[k][motions[j].index] * joints[j].at_pulses(k);
      first += joints[j].count();
    }
    force.columns.push_back(std::move(all));
  }
  return force;
}

FreeForceTest test_free_force(const ForceTask& task, const WhitenedSegments& whitened, const FreeForce& force) {
  FreeForceTest result;
  result.held_out = held_out_deviance(task.base, task.folds);
  if (force.empty()) return result;
  const Eigen::MatrixXd projected = whitened.project(force.columns);
  const Eigen::MatrixXd combinations = independent(projected);
  result.freedom = static_cast<int>(combinations.cols());
  if (result.freedom == 0) return result;
  const Eigen::MatrixXd scores = scores_of(whitened, dense::product(projected, combinations), force.pieces);
  result.deviance = scores.rowwise().sum().squaredNorm();
  std::vector<Eigen::MatrixXd> columns;
  for (const Eigen::MatrixXd& one : force.columns) columns.push_back(dense::product(one, combinations));
  ForceRegression regression(task.base, task.factors, columns, task.folds);
  ForceRegression::Columns all(static_cast<std::size_t>(result.freedom));
  std::iota(all.begin(), all.end(), Eigen::Index{0});
  double ridge = best_ridge(regression, all);
  for (int time = 0; time < kMostChoices && regression.settle(all, ridge); ++time) ridge = best_ridge(regression, all);
  result.held_out = regression.held_out(all, ridge);
  const Chances chances = p_by_chance(scores, result.deviance, task.seed);
  result.p = chances[0];
  result.p_low = chances[1];
  result.p_high = chances[2];
  result.curves = force.curves;
  draw_curves(force.readings * combinations, regression.sizes(all, ridge), regression.covariance(all, ridge),
              result.curves);
  return result;
}

}  // namespace lacuna
