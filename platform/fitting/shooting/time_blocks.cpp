#include "fitting/shooting/time_blocks.h"

#include <algorithm>
#include <utility>

namespace lacuna {
namespace {

/// First and last scored moment of each trial.
std::map<std::size_t, std::pair<double, double>> scored_spans(const ShootingProblem& problem) {
  std::map<std::size_t, std::pair<double, double>> spans;
  for (std::size_t k = 0; k < problem.segments().size(); ++k) {
    const Eigen::Index rows = problem.robust_rows(k);
    if (rows == 0) continue;
    const ResidualPlace first = problem.place(k, 0);
    auto& span = spans.try_emplace(first.trial, first.time, first.time).first->second;
    span.first = std::min(span.first, first.time);
    span.second = std::max(span.second, problem.place(k, rows - 1).time);
  }
  return spans;
}

}  // namespace

TimeBlocks::TimeBlocks(const ShootingProblem& problem, double length) : problem_(problem) {
  for (const auto& [trial, span] : scored_spans(problem)) {
    const double blocks = length > 0.0 ? (span.second - span.first) / length : 1.0;
    spans_[trial] = {span.first, span.second, count_, std::max(1, static_cast<int>(std::min(blocks, 1e6)))};
    count_ += spans_[trial].blocks;
  }
}

int TimeBlocks::of(std::size_t k, Eigen::Index row) const {
  const ResidualPlace place = problem_.place(k, row < problem_.robust_rows(k) ? row : 0);
  const Span& span = spans_.at(place.trial);
  const double share = span.end > span.begin ? (place.time - span.begin) / (span.end - span.begin) : 0.0;
  return span.first + std::min(span.blocks - 1, static_cast<int>(share * span.blocks));
}

double scored_duration(const ShootingProblem& problem) {
  double sum = 0.0;
  for (const auto& [trial, span] : scored_spans(problem)) sum += span.second - span.first;
  return sum;
}

}  // namespace lacuna
