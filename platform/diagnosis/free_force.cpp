#include "diagnosis/free_force.h"

#include "diagnosis/force_interaction.h"

#include <Eigen/Eigenvalues>
#include <boost/math/distributions/chi_squared.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lacuna {
namespace {

constexpr int kPositions = 14, kVelocities = 15, kCommands = 7;  // functions of each
constexpr std::array kSlices = {0.03, 0.5, 0.97};  // of the positions, at which the force is drawn against velocity ...
constexpr int kSliceKnots = 9;                     // ... at so many velocities
constexpr double kNear = 0.1, kSeen = 0.05;        // of the range of positions; of the velocities there
constexpr double kRounding = 1e-6;                 // of the strongest direction
constexpr std::array kRidges = {0.001, 0.01, 0.1, 1.0, 10.0, 100.0, 1000.0};

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
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(unit.asDiagonal() * (columns.transpose() * columns) *
                                                             unit.asDiagonal());
  const double least = kRounding * std::max(eigen.eigenvalues().maxCoeff(), 1e-300);
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = eigen.eigenvalues().size() - 1; i >= 0; --i)
    if (eigen.eigenvalues()(i) > least) kept.push_back(i);
  return unit.asDiagonal() * Eigen::MatrixXd(eigen.eigenvectors()(Eigen::all, kept));
}

/// The force where `readings` say, and its standard errors.
void draw_curves(const Eigen::MatrixXd& readings, const Eigen::MatrixXd& combinations, const Eigen::MatrixXd& gram,
                 const Eigen::VectorXd& score, double ridge, std::vector<ForceCurve>& curves) {
  Eigen::MatrixXd information = gram;
  information.diagonal().array() += ridge;
  const Eigen::LLT<Eigen::MatrixXd> solver(information);
  const Eigen::MatrixXd seen = readings * combinations;
  const Eigen::VectorXd force = seen * solver.solve(score);
  const Eigen::VectorXd variance = solver.matrixL().solve(seen.transpose()).colwise().squaredNorm();
  Eigen::Index row = 0;
  for (ForceCurve& curve : curves)
    for (std::size_t i = 0; i < curve.at.size(); ++i, ++row) {
      curve.force.push_back(force(row));
      curve.standard_error.push_back(std::sqrt(variance(row)));
    }
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

FreeForceTest test_free_force(const WhitenedSegments& whitened, const FreeForce& force,
                              const std::vector<std::size_t>& folds) {
  FreeForceTest result;
  result.held_out = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(folds.size()));
  if (force.empty()) return result;
  const Eigen::MatrixXd all = whitened.project(force.columns);
  const Eigen::MatrixXd combinations = independent(all);
  const Eigen::MatrixXd columns = all * combinations;
  const Eigen::VectorXd& residual = whitened.residual();
  const Eigen::MatrixXd gram = columns.transpose() * columns;
  const Eigen::VectorXd score = columns.transpose() * residual;
  result.freedom = static_cast<int>(columns.cols());
  if (result.freedom == 0) return result;
  result.deviance = score.dot(gram.ldlt().solve(score));
  const boost::math::chi_squared chance(result.freedom);
  result.p = boost::math::cdf(boost::math::complement(chance, std::max(0.0, result.deviance)));
  const std::size_t last = *std::max_element(folds.begin(), folds.end());
  double least = INFINITY, best = kRidges.front();
  for (const double ridge : kRidges) {
    Eigen::VectorXd deviance = Eigen::VectorXd::Zero(result.held_out.size());
    for (std::size_t f = 0; f <= last; ++f) {
      Eigen::MatrixXd others = gram;
      Eigen::VectorXd wanted = score;
      for (std::size_t k = 0; k < folds.size(); ++k) {
        if (folds[k] != f) continue;
        const Eigen::Index rows = whitened.first(k + 1) - whitened.first(k);
        const auto part = columns.middleRows(whitened.first(k), rows);
        others -= part.transpose() * part;
        wanted -= part.transpose() * residual.segment(whitened.first(k), rows);
      }
      others.diagonal().array() += ridge;
      const Eigen::VectorXd sizes = others.ldlt().solve(wanted);
      for (std::size_t k = 0; k < folds.size(); ++k) {
        if (folds[k] != f) continue;
        const Eigen::Index rows = whitened.first(k + 1) - whitened.first(k);
        deviance(static_cast<Eigen::Index>(k)) =
            (residual.segment(whitened.first(k), rows) - columns.middleRows(whitened.first(k), rows) * sizes)
                .squaredNorm();
      }
    }
    if (deviance.sum() < least) {
      least = deviance.sum();
      best = ridge;
      result.held_out = deviance;
    }
  }
  result.curves = force.curves;
  draw_curves(force.readings, combinations, gram, score, best, result.curves);
  return result;
}

}  // namespace lacuna
