#include "diagnosis/free_force.h"

#include <Eigen/Eigenvalues>
#include <boost/math/distributions/chi_squared.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lacuna {
namespace {

constexpr int kPositions = 14, kVelocities = 15, kCommands = 7;  // functions of each
constexpr double kRounding = 1e-6;                               // of the strongest direction
constexpr std::array kRidges = {0.1, 1.0, 10.0, 100.0, 1000.0};

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

/// Knots at quantiles, so that each function sees as much data.
std::vector<double> knots(const Regressor& regressor) {
  std::vector<double> all;
  for (const Eigen::VectorXd& values : regressor.values) all.insert(all.end(), values.begin(), values.end());
  std::sort(all.begin(), all.end());
  std::vector<double> chosen;
  for (int i = 0; i < regressor.functions; ++i) {
    const double share = static_cast<double>(i) / (regressor.functions - 1);
    const double knot = all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))];
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

/// Forces at the knots, and their standard errors.
void draw_curves(const Eigen::MatrixXd& combinations, const Eigen::MatrixXd& gram, const Eigen::VectorXd& score,
                 double ridge, std::vector<ForceCurve>& curves) {
  Eigen::MatrixXd information = gram;
  information.diagonal().array() += ridge;
  const Eigen::LLT<Eigen::MatrixXd> solver(information);
  const Eigen::VectorXd force = combinations * solver.solve(score);
  const Eigen::VectorXd variance = solver.matrixL().solve(combinations.transpose()).colwise().squaredNorm();
  Eigen::Index row = 0;
  for (ForceCurve& curve : curves)
    for (std::size_t i = 0; i < curve.at.size(); ++i, ++row) {
      curve.force.push_back(force(row));
      curve.standard_error.push_back(std::sqrt(variance(row)));
    }
}

}  // namespace

FreeForce free_force(const std::vector<JointMotion>& motions, const ForceResponses& forces) {
  FreeForce force;
  std::vector<std::vector<Eigen::VectorXd>> columns(forces.of.size());
  for (const JointMotion& motion : motions)
    for (const Regressor& one : regressors(motion)) {
      const std::vector<double> at = knots(one);
      if (at.size() < 3) continue;
      force.curves.push_back({motion.joint, one.name, one.unit, motion.force_unit, at, {}, {}});
      for (std::size_t i = 0; i < at.size(); ++i)
        for (std::size_t k = 0; k < columns.size(); ++k)
          columns[k].emplace_back(forces.of[k][motion.index] *
                                  one.values[k].unaryExpr([&](double x) { return hat(at, i, x); }));
    }
  for (std::size_t k = 0; k < columns.size() && !force.empty(); ++k) {
    Eigen::MatrixXd all(columns[k].front().size(), static_cast<Eigen::Index>(columns[k].size()));
    for (std::size_t i = 0; i < columns[k].size(); ++i) all.col(static_cast<Eigen::Index>(i)) = columns[k][i];
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
  draw_curves(combinations, gram, score, best, result.curves);
  return result;
}

}  // namespace lacuna
