#include "diagnosis/nuisance.h"

#include "diagnosis/timing.h"

#include <Eigen/QR>

namespace lacuna {
namespace {

constexpr double kAlike = 0.035;  ///< share below which a column is another one, scaled
constexpr double kPerhaps = 0.3;  ///< the same where they are of other sizes, and not linear in them

/// What a start cannot make up for, of columns of its segment.
Eigen::MatrixXd beside_start(const Eigen::MatrixXd& state, const Eigen::MatrixXd& columns) {
  if (state.cols() == 0) return columns;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(state);
  const Eigen::MatrixXd basis = qr.householderQ() * Eigen::MatrixXd::Identity(state.rows(), qr.rank());
  return columns - basis * (basis.transpose() * columns);
}

/// A column fitted by others, starts apart.
struct Likeness {
  Eigen::VectorXd sizes;  ///< of the others
  double left = 0.0;      ///< share of the column's power that they do not span
};

Likeness likeness(const std::vector<Eigen::MatrixXd>& column, const std::vector<Eigen::MatrixXd>& others,
                  const std::vector<LinearSegment>& segments) {
  const Eigen::Index count = others.front().cols();
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd mixed = Eigen::VectorXd::Zero(count);
  double power = 0.0;
  for (std::size_t k = 0; k < column.size(); ++k) {
    const Eigen::MatrixXd own = beside_start(segments[k].state, column[k]);
    const Eigen::MatrixXd spanned = beside_start(segments[k].state, others[k]);
    gram += spanned.transpose() * spanned;
    mixed += spanned.transpose() * own.col(0);
    power += own.squaredNorm();
  }
  const Eigen::VectorXd sizes = gram.completeOrthogonalDecomposition().solve(mixed);
  return {sizes, power > 0.0 ? 1.0 - mixed.dot(sizes) / power : 0.0};
}

}  // namespace

bool is_among(const std::vector<Eigen::MatrixXd>& column, const std::vector<Eigen::MatrixXd>& others,
              const std::vector<LinearSegment>& segments) {
  return likeness(column, others, segments).left < kAlike;
}

bool acts_as_timing(const Probe& probe, const Contender& contender, const BaseSolution& base, const RowBins& bins) {
  if (base.nuisance.empty()) return false;
  const std::vector<Eigen::MatrixXd> response(probe.response.begin(), probe.response.end());
  const Likeness roughly = likeness(response, base.nuisance, base.linear);
  const double shift = -roughly.sizes(0);  // the response is of the prediction, the timing of the residual
  if (roughly.left > kPerhaps || shift == 0.0) return false;
  const std::vector<Eigen::MatrixXd> as_large =
      timing_columns(*contender.model, contender.definition, base, bins, 1, shift);
  return !as_large.empty() && is_among(response, as_large, base.linear);
}

std::vector<Eigen::MatrixXd> timing_beside(const Contender& contender, const BaseSolution& base, const RowBins& bins,
                                           int threads) {
  std::vector<Eigen::MatrixXd> timing = timing_columns(*contender.model, contender.definition, base, bins, threads);
  if (timing.empty()) return timing;
  std::vector<Eigen::MatrixXd> values;
  for (const LinearSegment& segment : base.linear) values.push_back(segment.values);
  if (values.front().cols() > 0 && is_among(timing, values, base.linear)) timing.clear();
  return timing;
}

std::vector<LinearSegment> with_nuisance(const BaseSolution& base, const Refit& fit) {
  std::vector<LinearSegment> segments = base.linear;
  const Eigen::Index count = fit.nuisance.size();
  for (std::size_t k = 0; k < segments.size() && count > 0; ++k) {
    segments[k].residual += base.nuisance[k] * fit.nuisance;
    for (Eigen::Index i = 0; i < count; ++i) {
      if (fit.at_bound[fit.at_bound.size() - static_cast<std::size_t>(count - i)]) continue;
      segments[k].values.conservativeResize(Eigen::NoChange, segments[k].values.cols() + 1);
      segments[k].values.rightCols(1) = base.nuisance[k].col(i);
    }
  }
  return segments;
}

}  // namespace lacuna
