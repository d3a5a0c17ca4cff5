#include "horizons/linear_ladder.h"

#include <lacuna/error.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lacuna {
namespace {

constexpr double kFarRow = 4.0;  ///< rms
constexpr int kMostReweightings = 40;
constexpr double kSettledCost = 1e-5;  ///< nats a round
constexpr double kDamping = 0.01;      ///< of a diagonal, where blocks are left out: what data hardly tell stays
constexpr double kRidge = 1e-9;        ///< of a diagonal
constexpr double kTold = 1e-3;         ///< eigenvalue of a combination of values that data tell, of 1
constexpr int kEnoughTrials = 3;       ///< of which one can be left out
constexpr int kFewestBlocks = 6;       ///< beside one a value, by which an error is estimated

/// Minimises ½ sᵀAs − bᵀs within bounds: what would leave them is put on them, one after the other.
Eigen::VectorXd bounded_minimum(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, const Eigen::VectorXd& lower,
                                const Eigen::VectorXd& upper) {
  const Eigen::Index n = b.size();
  Eigen::VectorXd sizes = Eigen::VectorXd::Zero(n);
  std::vector<bool> held(static_cast<std::size_t>(n), false);
  for (Eigen::Index round = 0; round <= n; ++round) {
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < n; ++i)
      if (!held[static_cast<std::size_t>(i)] && a(i, i) > 0.0) free.push_back(i);
    if (free.empty()) break;
    Eigen::VectorXd rest = b;
    for (Eigen::Index i = 0; i < n; ++i)
      if (held[static_cast<std::size_t>(i)]) rest -= sizes(i) * a.col(i);
    Eigen::MatrixXd part = a(free, free);
    part.diagonal() *= 1.0 + kRidge;
    const Eigen::VectorXd found = part.ldlt().solve(rest(free));
    Eigen::Index worst = -1;
    double beyond = 0.0;
    for (std::size_t f = 0; f < free.size(); ++f) {
      const Eigen::Index i = free[f];
      sizes(i) = found(static_cast<Eigen::Index>(f));
      const double off = std::max(lower(i) - sizes(i), sizes(i) - upper(i)) * std::sqrt(a(i, i));
      if (off > beyond) beyond = off, worst = i;
    }
    if (worst < 0) break;
    sizes(worst) = std::clamp(sizes(worst), lower(worst), upper(worst));
    held[static_cast<std::size_t>(worst)] = true;
  }
  return sizes.cwiseMax(lower).cwiseMin(upper);
}

/// Of normal equations, whatever the units of their values.
int rank_of(const Eigen::MatrixXd& normal) {
  const Eigen::VectorXd lengths = normal.diagonal().cwiseSqrt();
  Eigen::MatrixXd scaled = normal;
  for (Eigen::Index i = 0; i < lengths.size(); ++i) {
    const double factor = lengths(i) > 0.0 ? 1.0 / lengths(i) : 0.0;
    scaled.row(i) *= factor;
    scaled.col(i) *= factor;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled, Eigen::EigenvaluesOnly);
  return static_cast<int>((solver.eigenvalues().array() > kTold).count());
}

}  // namespace

LinearLadder::LinearLadder(const Parts& parts)
    : rungs_(parts.ladder.rungs.size()),
      channels_(parts.ladder.channels.size()),
      room_below_(parts.room_below),
      room_above_(parts.room_above) {
  place_rows(parts);
  prepare_starts(parts);
  const Eigen::Index own = room_below_.size();
  base_.resize(static_cast<Eigen::Index>(places_.size()), 1 + own);
  base_.col(0) = gathered(parts.fit.residuals, start_residuals_);
  std::vector<Eigen::VectorXd> column(parts.own.size());
  for (Eigen::Index i = 0; i < own; ++i) {
    for (std::size_t k = 0; k < column.size(); ++k) column[k] = parts.own[k].col(i);
    base_.col(1 + i) = gathered(column);
  }
  row_weights_.resize(base_.rows());
  for (const Cell& cell : cells_) {
    const auto rows = base_.middleRows(cell.first, cell.size);
    base_products_.emplace_back(rows.transpose() * rows);
    const double mean = base_products_.back()(0, 0) / cell.count;
    row_weights_.segment(cell.first, cell.size).setConstant(cell.weight / (cell.count * std::max(mean, cell.floor)));
    cost_ += cell.weight * lacuna::cost_of(mean, cell.floor);
  }
}

void LinearLadder::place_rows(const Parts& parts) {
  std::vector<int> first_block;
  for (const Trial& trial : parts.trials) {
    first_block.push_back(blocks_);
    const Eigen::VectorXd& times = trial.measured.times;
    if (trial.held_out) continue;
    blocks_ += 1 + static_cast<int>((times(times.size() - 1) - times(0)) / parts.block);
    trial_of_block_.resize(static_cast<std::size_t>(blocks_), trials_++);
  }
  std::vector<std::vector<Place>> of_cells(rungs_ * channels_);
  std::size_t k = 0;
  for (std::size_t rung = 0; rung < rungs_; ++rung)
    for (const Segment& segment : parts.ladder.rungs[rung].segments) {
      const Trial& trial = parts.trials[segment.stretch.trial];
      weights_.emplace_back(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(segment.rows.size())));
      for (std::size_t r = 0; r < segment.rows.size(); ++r) {
        const std::size_t channel = channel_index(parts.ladder, trial, segment.columns[r]);
        if (parts.fit.errors.weight[rung][channel] == 0.0) continue;
        const double mean = parts.fit.errors.mean_square[rung][channel];
        const double off = std::abs(parts.fit.residuals[k](static_cast<Eigen::Index>(r)));
        const double factor = off > kFarRow * std::sqrt(mean) ? kFarRow * std::sqrt(mean) / off : 1.0;
        const double time = trial.measured.times(segment.stretch.first + segment.rows[r]) - trial.measured.times(0);
        const int block = first_block[segment.stretch.trial] + static_cast<int>(time / parts.block);
        of_cells[rung * channels_ + channel].push_back({k, static_cast<Eigen::Index>(r), block, factor});
      }
      ++k;
    }
  for (std::size_t c = 0; c < of_cells.size(); ++c) {
    if (of_cells[c].empty()) continue;
    Cell cell;
    cell.first = static_cast<Eigen::Index>(places_.size());
    cell.size = static_cast<Eigen::Index>(of_cells[c].size());
    cell.rung = c / channels_;
    cell.channel = c % channels_;
    cell.count = static_cast<double>(cell.size);
    cell.weight = parts.fit.errors.weight[cell.rung][cell.channel];
    cell.floor = parts.ladder.rungs[cell.rung].floor[cell.channel];
    const double mean = std::max(parts.fit.errors.mean_square[cell.rung][cell.channel], cell.floor);
    for (const Place& place : of_cells[c])
      weights_[place.segment](place.row) = cell.weight / (cell.count * mean) * place.factor * place.factor;
    places_.insert(places_.end(), of_cells[c].begin(), of_cells[c].end());
    cells_.push_back(cell);
  }
}

/// A start that is refitted within its prior answers a change of its rows with (SᵀWS + P⁻¹)⁻¹SᵀW of it.
void LinearLadder::prepare_starts(const Parts& parts) {
  starts_ = parts.starts;
  refits_.resize(weights_.size());
  start_residuals_.resize(weights_.size());
  start_own_.resize(weights_.size());
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    if (k >= starts_.size() || starts_[k].cols() == 0 || !(weights_[k].sum() > 0.0)) continue;
    const Eigen::MatrixXd weighted = starts_[k].transpose() * weights_[k].asDiagonal();
    Eigen::MatrixXd normal = weighted * starts_[k];
    normal.diagonal().array() += parts.fit.prior_weight / parts.priors[k].array().square();
    const Eigen::LDLT<Eigen::MatrixXd> solver(normal);
    const Eigen::Index rows = weighted.cols();
    refits_[k] = solver.solve(weighted);
    start_residuals_[k] = refits_[k] * parts.fit.residuals[k].head(rows);
    // Below its rows a segment's residuals are how far its start is off, in standard deviations.
    const Eigen::VectorXd off = parts.fit.residuals[k].tail(parts.priors[k].size());
    start_residuals_[k] -= solver.solve(parts.fit.prior_weight * off.cwiseQuotient(parts.priors[k]));
    start_own_[k] = refits_[k] * parts.own[k];
  }
}

LadderStep LinearLadder::step(double damping) const {
  const LinearFit found = best({}, damping);
  LadderStep step{found.sizes, std::vector<Eigen::VectorXd>(refits_.size()), cost_ - found.cost};
  for (std::size_t k = 0; k < refits_.size(); ++k)
    if (refits_[k].size() > 0) step.states[k] = start_residuals_[k] - start_own_[k] * found.sizes;
  return step;
}

Eigen::VectorXd LinearLadder::gathered(const std::vector<Eigen::VectorXd>& by_segment) const {
  std::vector<Eigen::VectorXd> answers(by_segment.size());
  for (std::size_t k = 0; k < answers.size(); ++k)
    if (refits_[k].size() > 0) answers[k] = refits_[k] * by_segment[k];
  return gathered(by_segment, answers);
}

Eigen::VectorXd LinearLadder::gathered(const std::vector<Eigen::VectorXd>& by_segment,
                                       const std::vector<Eigen::VectorXd>& answers) const {
  std::vector<Eigen::VectorXd> left = by_segment;
  for (std::size_t k = 0; k < left.size(); ++k)
    if (answers[k].size() > 0) left[k].head(starts_[k].rows()) -= starts_[k] * answers[k];
  Eigen::VectorXd rows(static_cast<Eigen::Index>(places_.size()));
  for (std::size_t i = 0; i < places_.size(); ++i)
    rows(static_cast<Eigen::Index>(i)) = places_[i].factor * left[places_[i].segment](places_[i].row);
  return rows;
}

std::size_t LinearLadder::add(const std::vector<Eigen::VectorXd>& response, double at_least, double at_most) {
  Change change{gathered(response), at_least, at_most, {}};
  for (const Cell& cell : cells_)
    change.with_base.emplace_back(base_.middleRows(cell.first, cell.size).transpose() *
                                  change.rows.segment(cell.first, cell.size));
  changes_.push_back(std::move(change));
  return changes_.size() - 1;
}

Eigen::MatrixXd LinearLadder::products(const Cell& cell, std::size_t index,
                                       std::span<const std::size_t> changes) const {
  const Eigen::Index base = base_.cols(), all = base + static_cast<Eigen::Index>(changes.size());
  Eigen::MatrixXd products(all, all);
  products.topLeftCorner(base, base) = base_products_[index];
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const Change& change = changes_[changes[i]];
    const Eigen::Index at = base + static_cast<Eigen::Index>(i);
    products.col(at).head(base) = change.with_base[index];
    for (std::size_t j = 0; j <= i; ++j)
      products(base + static_cast<Eigen::Index>(j), at) =
          change.rows.segment(cell.first, cell.size).dot(changes_[changes[j]].rows.segment(cell.first, cell.size));
  }
  products.triangularView<Eigen::StrictlyLower>() = products.transpose();
  return products;
}

double LinearLadder::cost_of_squares(const std::vector<Eigen::MatrixXd>& products, const Eigen::VectorXd& sizes,
                                     std::vector<double>& means) const {
  double cost = 0.0;
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const Eigen::MatrixXd& p = products[c];
    const Eigen::Index n = sizes.size();
    const double square = p(0, 0) - 2.0 * sizes.dot(p.col(0).tail(n)) + sizes.dot(p.bottomRightCorner(n, n) * sizes);
    means[c] = std::max(square, 1e-12 * p(0, 0)) / cells_[c].count;
    cost += cells_[c].weight * lacuna::cost_of(means[c], cells_[c].floor);
  }
  return cost;
}

LinearFit LinearLadder::best(std::span<const std::size_t> changes, double damping) const {
  std::vector<Eigen::MatrixXd> all;
  for (std::size_t c = 0; c < cells_.size(); ++c) all.push_back(products(cells_[c], c, changes));
  const Eigen::Index own = room_below_.size(), n = own + static_cast<Eigen::Index>(changes.size());
  Eigen::VectorXd lower(n), upper(n);
  lower.head(own) = -room_below_;
  upper.head(own) = room_above_;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    lower(own + static_cast<Eigen::Index>(i)) = changes_[changes[i]].at_least;
    upper(own + static_cast<Eigen::Index>(i)) = changes_[changes[i]].at_most;
  }
  LinearFit fit;
  fit.sizes = Eigen::VectorXd::Zero(n);
  std::vector<double> means(cells_.size());
  fit.cost = cost_of_squares(all, fit.sizes, means);
  for (int round = 0; round < kMostReweightings && n > 0; ++round) {
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(n);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const double weight = cells_[c].weight / (cells_[c].count * std::max(means[c], cells_[c].floor));
      normal += weight * all[c].bottomRightCorner(n, n);
      gradient += weight * all[c].col(0).tail(n);
    }
    normal.diagonal() *= 1.0 + damping;
    const Eigen::VectorXd sizes = bounded_minimum(normal, gradient, lower, upper);
    const double cost = cost_of_squares(all, sizes, means);
    if (!(cost < fit.cost)) break;
    const double gained = fit.cost - cost;
    fit.sizes = sizes;
    fit.cost = cost;
    if (gained < kSettledCost) break;
  }
  cost_of_squares(all, fit.sizes, means);
  fit.mean_square.assign(rungs_, std::vector<double>(channels_, 0.0));
  for (std::size_t c = 0; c < cells_.size(); ++c) fit.mean_square[cells_[c].rung][cells_[c].channel] = means[c];
  return fit;
}

/// H⁻¹ Σ s sᵀ H⁻¹ with the scores s of blocks, which may be correlated within (P. J. Huber, 1967), and with their
/// neighbours: each value is as uncertain as blocks once, twice or four times as long say at most. What horizons say
/// differently is not chance but form, and is added: a jackknife that leaves out one rung after the other.
Eigen::MatrixXd LinearLadder::covariance(Eigen::MatrixXd normal) const {
  const Eigen::Index own = normal.rows();
  normal.diagonal() *= 1.0 + kRidge;
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(blocks_, own);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    scores.row(places_[i].block) += row_weights_(row) * base_(row, 0) * base_.row(row).tail(own);
  }
  scores.rowwise() -= scores.colwise().mean().eval();
  const Eigen::LDLT<Eigen::MatrixXd> solved = normal.ldlt();
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(own, own);
  Eigen::VectorXd most = Eigen::VectorXd::Zero(own);
  for (int together = 1; together <= 4 && (together == 1 || blocks_ / together >= kFewestBlocks + own); together *= 2) {
    const int groups = (blocks_ + together - 1) / together;
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(own, groups);
    for (int b = 0; b < blocks_; ++b) sums.col(b / together) += scores.row(b).transpose();
    const double few = static_cast<double>(groups) / std::max(1.0, static_cast<double>(groups - 1 - own));
    const Eigen::MatrixXd moved = solved.solve(sums);
    const Eigen::MatrixXd one = few * moved * moved.transpose();
    if (together == 1) all = one;
    most = most.cwiseMax(one.diagonal());
  }
  const Eigen::VectorXd wider = (most.array() / all.diagonal().array().max(1e-300)).sqrt();
  return wider.asDiagonal() * all * wider.asDiagonal() + between_rungs(normal);
}

/// Of the values that a fit without one rung would have, to first order.
Eigen::MatrixXd LinearLadder::between_rungs(const Eigen::MatrixXd& normal) const {
  const Eigen::Index own = normal.rows();
  std::vector<Eigen::MatrixXd> of_rung(rungs_, Eigen::MatrixXd::Zero(own, own + 1));
  for (const Cell& cell : cells_) {
    const auto rows = base_.middleRows(cell.first, cell.size);
    const Eigen::VectorXd weights = row_weights_.segment(cell.first, cell.size);
    of_rung[cell.rung] += rows.rightCols(own).transpose() * weights.asDiagonal() * rows;
  }
  std::vector<Eigen::VectorXd> moved;
  for (const Eigen::MatrixXd& rung : of_rung) {
    if (rung.isZero(0.0)) continue;
    Eigen::MatrixXd others = normal - rung.rightCols(own);
    others.diagonal() += kDamping * normal.diagonal();
    moved.emplace_back(others.ldlt().solve(-rung.col(0)));
  }
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(own, own);
  if (moved.size() < 2) return sum;
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(own);
  for (const Eigen::VectorXd& one : moved) mean += one / static_cast<double>(moved.size());
  for (const Eigen::VectorXd& one : moved) sum += (one - mean) * (one - mean).transpose();
  return sum * (1.0 - 1.0 / static_cast<double>(moved.size()));
}

CrossFit LinearLadder::cross_fit(int stretches) const {
  const Eigen::Index own = base_.cols() - 1;
  const bool by_trial = trials_ >= kEnoughTrials;
  const int folds = by_trial ? trials_ : stretches;
  const auto fold_of = [&](const Place& place) {
    return static_cast<std::size_t>(by_trial ? trial_of_block_[static_cast<std::size_t>(place.block)]
                                             : place.block * folds / blocks_);
  };
  // Normal equations by fold, of which each leaves its own out.
  std::vector<Eigen::MatrixXd> parts(static_cast<std::size_t>(folds), Eigen::MatrixXd::Zero(own + 1, own + 1));
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto row = base_.row(static_cast<Eigen::Index>(i));
    parts[fold_of(places_[i])] += row_weights_(static_cast<Eigen::Index>(i)) * row.transpose() * row;
  }
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(own + 1, own + 1);
  for (const Eigen::MatrixXd& part : parts) all += part;
  std::vector<Eigen::VectorXd> sizes;
  for (const Eigen::MatrixXd& part : parts) {
    Eigen::MatrixXd others = all - part;
    others.diagonal().tail(own) *= 1.0 + kDamping;
    sizes.push_back(
        bounded_minimum(others.bottomRightCorner(own, own), others.col(0).tail(own), -room_below_, room_above_));
  }
  CrossFit fit{0.0, Eigen::VectorXd::Zero(blocks_), covariance(all.bottomRightCorner(own, own)),
               rank_of(all.bottomRightCorner(own, own))};
  for (const Cell& cell : cells_) {
    Eigen::VectorXd squares(cell.size);
    for (Eigen::Index i = 0; i < cell.size; ++i) {
      const Eigen::Index row = cell.first + i;
      const Eigen::VectorXd& moved = sizes[fold_of(places_[static_cast<std::size_t>(row)])];
      squares(i) = std::pow(base_(row, 0) - base_.row(row).tail(own).dot(moved), 2);
    }
    const double mean = squares.mean(), slope = cell.weight * slope_of_cost(mean, cell.floor) / cell.count;
    fit.cost += cell.weight * lacuna::cost_of(mean, cell.floor);
    for (Eigen::Index i = 0; i < cell.size; ++i)
      fit.by_block(places_[static_cast<std::size_t>(cell.first + i)].block) += slope * (squares(i) - mean);
  }
  return fit;
}

LinearLadder linearise(const Ladder& ladder, const TrialPredictor& predictor, const ParameterSpace& space,
                       const HorizonFit& fit, double block) {
  ShootingProblem problem(predictor, space, all_segments(ladder), ladder.channels);
  const FitPoint point{space.clamp(space.to_coordinates(fit.values)), fit.states};
  std::vector<Eigen::VectorXd> residuals;
  if (!problem.residuals(point, residuals))
    throw Error("the fitted model cannot be simulated: " + problem.last_reason());
  std::vector<SegmentJacobian> jacobians;
  problem.linearize(point, residuals, jacobians);
  LinearLadder::Parts parts{ladder, predictor.trials(), fit, {}, {}, {}, {}, {}, block};
  for (std::size_t k = 0; k < jacobians.size(); ++k) {
    const auto rows = static_cast<Eigen::Index>(problem.segments()[k].rows.size());
    Eigen::VectorXd scales(rows);
    for (Eigen::Index row = 0; row < rows; ++row) scales(row) = problem.scales()[problem.place(k, row).channel];
    parts.own.emplace_back(-(scales.asDiagonal() * jacobians[k].values.topRows(rows)));
    const bool refits = !problem.segments()[k].unknown.empty();
    parts.starts.push_back(refits ? Eigen::MatrixXd(-(scales.asDiagonal() * jacobians[k].state.topRows(rows)))
                                  : Eigen::MatrixXd());
    parts.priors.push_back(problem.segments()[k].deviation);
  }
  parts.room_below = point.values - space.lower();
  parts.room_above = space.upper() - point.values;
  return LinearLadder(parts);
}

}  // namespace lacuna
