#include "horizons/horizon_errors.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kWinsor = 4.0;  ///< rms
constexpr int kWinsorRounds = 100;
constexpr double kSettled = 1e-3;  ///< of the mean, from round to round
constexpr double kFewEffective = 8.0;

/// Squared residuals of one rung and channel, by segment.
struct Cell {
  std::vector<double> squares;
  std::vector<std::size_t> segment_ends;
};

double winsorised_mean(const Cell& cell) {
  double mean = 0.0;
  for (const double square : cell.squares) mean += square / static_cast<double>(cell.squares.size());
  for (int round = 0; round < kWinsorRounds; ++round) {
    const double most = kWinsor * kWinsor * mean;
    double sum = 0.0;
    for (const double square : cell.squares) sum += std::min(square, most);
    const double before = mean;
    mean = sum / static_cast<double>(cell.squares.size());
    if (before - mean <= kSettled * mean) break;
  }
  return mean;
}

/// 2 m²/Var(m) with the variance of means of segments: how many independent squares the mean is worth.
double effective_samples(const Cell& cell, double mean) {
  std::vector<double> means;
  std::size_t begin = 0;
  for (const std::size_t end : cell.segment_ends) {
    if (end == begin) continue;
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) sum += std::min(cell.squares[i], kWinsor * kWinsor * mean);
    means.push_back(sum / static_cast<double>(end - begin));
    begin = end;
  }
  if (means.size() < 3) return static_cast<double>(means.size());
  double spread = 0.0;
  for (const double one : means) spread += (one - mean) * (one - mean);
  const auto count = static_cast<double>(means.size());
  const double variance = spread / (count * (count - 1.0));
  return variance > 0.0 ? 2.0 * mean * mean / variance : kFewEffective;
}

/// By rung and channel.
std::vector<std::vector<Cell>> cells_of(const Ladder& ladder, const std::vector<Trial>& trials,
                                        const std::vector<Eigen::VectorXd>& residuals) {
  std::vector<std::vector<Cell>> all;
  std::size_t k = 0;
  for (const Rung& rung : ladder.rungs) {
    std::vector<Cell>& cells = all.emplace_back(ladder.channels.size());
    for (const Segment& segment : rung.segments) {
      const Trial& trial = trials[segment.stretch.trial];
      std::vector<std::size_t> index;
      for (Eigen::Index column = 0; column < trial.measured.samples.cols(); ++column)
        index.push_back(channel_index(ladder, trial, column));
      for (std::size_t r = 0; r < segment.rows.size(); ++r)
        cells[index[static_cast<std::size_t>(segment.columns[r])]].squares.push_back(
            std::pow(residuals[k](static_cast<Eigen::Index>(r)), 2));
      for (Cell& cell : cells) cell.segment_ends.push_back(cell.squares.size());
      ++k;
    }
  }
  return all;
}

}  // namespace

double cost_of(double mean_square, double floor) {
  if (mean_square >= floor) return 0.5 * std::log(mean_square);
  return 0.5 * std::log(floor) + 0.5 * (mean_square / floor - 1.0);
}

double slope_of_cost(double mean_square, double floor) { return 0.5 / std::max(mean_square, floor); }

HorizonErrors horizon_errors(const Ladder& ladder, const std::vector<Trial>& trials,
                             const std::vector<Eigen::VectorXd>& residuals) {
  HorizonErrors errors;
  double total = 0.0;
  for (const std::vector<Cell>& cells : cells_of(ladder, trials, residuals)) {
    const Rung& rung = ladder.rungs[errors.mean_square.size()];
    errors.mean_square.emplace_back(cells.size(), 0.0);
    errors.weight.emplace_back(cells.size(), 0.0);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (cells[c].squares.empty() || rung.weight[c] == 0.0) continue;
      errors.mean_square.back()[c] = winsorised_mean(cells[c]);
      total += errors.weight.back()[c] = rung.weight[c];
    }
  }
  if (!(total > 0.0)) return errors;
  for (std::size_t r = 0; r < ladder.rungs.size(); ++r)
    for (std::size_t c = 0; c < ladder.channels.size(); ++c) {
      double& weight = errors.weight[r][c];
      if (weight == 0.0) continue;
      weight /= total;
      errors.cost += weight * cost_of(errors.mean_square[r][c], ladder.rungs[r].floor[c]);
    }
  errors.valid = std::isfinite(errors.cost);
  return errors;
}

void weigh_by_information(Ladder& ladder, const std::vector<Trial>& trials,
                          const std::vector<Eigen::VectorXd>& residuals) {
  const std::vector<std::vector<Cell>> cells = cells_of(ladder, trials, residuals);
  double total = 0.0;
  for (std::size_t r = 0; r < ladder.rungs.size(); ++r)
    for (std::size_t c = 0; c < ladder.channels.size(); ++c) {
      double& weight = ladder.rungs[r].weight[c];
      if (weight == 0.0) continue;
      const Cell& cell = cells[r][c];
      weight *=
          cell.squares.empty() ? 0.0 : std::min(1.0, effective_samples(cell, winsorised_mean(cell)) / kFewEffective);
      total += weight;
    }
  for (Rung& rung : ladder.rungs)
    for (double& weight : rung.weight) weight /= total;
}

}  // namespace lacuna
