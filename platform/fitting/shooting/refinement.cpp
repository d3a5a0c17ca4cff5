#include "fitting/shooting/refinement.h"

#include "fitting/shooting/residual_memory.h"
#include "fitting/shooting/states_problem.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr int kRounds = 3;           ///< alternations of scales and search
constexpr double kSettled = 0.05;    ///< relative change of scales that ends the alternation
constexpr double kRough = 1.0;       ///< precision while the scales still change
constexpr double kLoosest = 1e-4;    ///< relative decrease of the cost: loosest tolerance that ends a search
constexpr double kSameError = 1e-2;  ///< per sample: 0.5 % of the residual
constexpr double kHopeless = 2.0;    ///< per sample: 2.7 times the residual

bool settled(const std::vector<double>& before, const std::vector<double>& after) {
  for (std::size_t i = 0; i < before.size(); ++i)
    if (std::abs(after[i] - before[i]) > kSettled * before[i]) return false;
  return true;
}

std::vector<double> noise_scales(const ShootingProblem& problem) {
  std::vector<double> scales;
  for (const ChannelNoise& channel : problem.noise()) scales.push_back(channel.deviation);
  return scales;
}

/// The objective is that of a τ-scale (V. J. Yohai and R. H. Zamar, 1988): the logarithm of the robust scale plus a
/// loss that is bounded per sample. With an unbounded loss a few outliers would favour the candidate with the larger
/// scale.
void summarise(const ShootingProblem& problem, const RobustLoss& loss, Candidate& candidate) {
  double bounded = 0.0;
  double logarithms = 0.0, squares = 0.0;
  for (std::size_t k = 0; k < candidate.search.residuals.size(); ++k)
    for (Eigen::Index row = 0; row < problem.robust_rows(k); ++row) {
      const std::size_t channel = problem.place(k, row).channel;
      const double over_noise = candidate.scales[channel] / problem.noise()[channel].deviation;
      const double r = candidate.search.residuals[k](row);
      bounded += std::min(r * r, loss.threshold * loss.threshold);
      logarithms += std::log(over_noise);
      squares += std::pow(r * over_noise, 2);
    }
  candidate.objective = bounded + 2.0 * logarithms;
  candidate.samples = problem.samples();
  candidate.residual = std::sqrt(squares / static_cast<double>(problem.samples()));
}

/// Alternates searches with scales from the residuals of the last search. `searched`: the problem, or a restriction of
/// it.
void search_with_scales(ShootingProblem& problem, SegmentedProblem& searched, FitPoint point,
                        const RefinementOptions& options, Candidate& candidate) {
  std::vector<Eigen::VectorXd> residuals;
  problem.set_scales(noise_scales(problem));
  candidate.valid = searched.residuals(point, residuals);
  if (!candidate.valid) return;
  LeastSquaresOptions search;
  search.loss = options.loss;
  search.progress = options.progress;
  search.reached = options.reached;
  int iterations = 0;
  bool last = false;
  for (int round = 0; !last && iterations < options.max_iterations; ++round) {
    const std::vector<double> scales = residual_scales(problem, residuals, options.loss);
    last = round + 1 == kRounds || (round > 0 && settled(problem.scales(), scales));
    problem.set_scales(scales);
    const double precision = last ? options.precision : std::max(options.precision, kRough);
    search.tolerance = std::min(kLoosest, precision / residual_memory(problem, residuals).effective_samples);
    search.max_iterations = options.max_iterations - iterations;
    candidate.search = minimize(searched, point, search);
    candidate.valid = candidate.search.valid;
    if (!candidate.valid) return;  // a plugin's effect failed where it had not failed before
    iterations += candidate.search.iterations;
    point = candidate.search.point;
    residuals = candidate.search.residuals;
  }
  candidate.search.iterations = iterations;
  candidate.scales = problem.scales();
  candidate.steps = problem.steps();
  summarise(problem, options.loss, candidate);
}

bool same_error(const Candidate& a, const Candidate& b, std::size_t samples) {
  return std::abs(a.objective - b.objective) <= 1.0 + kSameError * static_cast<double>(samples);
}

}  // namespace

Candidate refine(ShootingProblem& problem, const Eigen::VectorXd& values, const RefinementOptions& options) {
  Candidate candidate;
  candidate.values = values;
  search_with_scales(problem, problem, problem.start(values), options, candidate);
  if (candidate.valid) candidate.values = candidate.search.point.values;
  return candidate;
}

Candidate evaluate(ShootingProblem& problem, const Eigen::VectorXd& values, const RefinementOptions& options) {
  Candidate candidate;
  candidate.values = values;
  StatesProblem states(problem, candidate.values);
  search_with_scales(problem, states, {Eigen::VectorXd(), problem.start(values).states}, options, candidate);
  candidate.search.point.values = values;
  if (!candidate.valid) return candidate;
  candidate.scales = residual_scales(problem, candidate.search.residuals, options.loss);
  problem.set_scales(candidate.scales);
  candidate.valid = problem.residuals(candidate.search.point, candidate.search.residuals);
  if (candidate.valid) summarise(problem, options.loss, candidate);
  return candidate;
}

std::vector<Eigen::VectorXd> starts_of(const std::vector<Candidate>& candidates) {
  std::vector<Eigen::VectorXd> starts;
  starts.reserve(candidates.size());
  for (const Candidate& candidate : candidates) starts.push_back(candidate.values);
  return starts;
}

int rank(std::vector<Candidate>& candidates, std::size_t samples) {
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.valid != b.valid ? a.valid : a.valid && a.objective < b.objective;
  });
  return static_cast<int>(std::count_if(candidates.begin(), candidates.end(), [&](const Candidate& candidate) {
    return candidate.valid && same_error(candidate, candidates.front(), samples);
  }));
}

void keep_best(std::vector<Candidate>& candidates, std::size_t samples) {
  const Candidate& best = candidates.front();
  const auto other = std::find_if(candidates.begin() + 1, candidates.end(), [&](const Candidate& candidate) {
    return candidate.valid && !same_error(candidate, best, samples) &&
           candidate.objective < best.objective + kHopeless * static_cast<double>(samples);
  });
  std::vector<Candidate> kept = {best};
  if (other != candidates.end()) kept.push_back(*other);
  candidates = std::move(kept);
}

}  // namespace lacuna
