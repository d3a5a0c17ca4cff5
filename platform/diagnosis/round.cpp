#include "diagnosis/round.h"

#include "diagnosis/contact_doubt.h"
#include "diagnosis/data_scales.h"
#include "diagnosis/timing.h"
#include "fitting/disturbance.h"
#include "foundation/interrupt.h"
#include "foundation/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <Eigen/QR>

namespace lacuna {
namespace {

constexpr std::size_t kFewestRefits = 5, kMostRefits = 10;  ///< refits
constexpr double kChance = 0.05;                            ///< beyond, the best score is no more than noise reaches
constexpr std::size_t kRefitsByChance = 2;                  ///< then, to be shown
constexpr double kComparable = 0.3;                         ///< of the best score: others as good are refitted, too
constexpr std::size_t kStarts = 2;                          ///< probes that a refit starts from
/// Of the deviance that a rival is worth by its score: a choice between rivals needs no finer fit, and the chosen one
/// is refitted in the next round.
constexpr double kFineEnough = 1e-3;
/// Rivals go on after so many iterations unless they are far behind the best: by that share of what it explains, and by
/// that much.
constexpr int kScoutIterations = 6;
constexpr double kFarBehind = 0.3, kFarDeviance = 20.0;

/// The model at its base solution, ready to be simulated.
struct BaseBench {
  BaseBench(const Contender& contender, const BaseSolution& start, int threads)
      : predictor(*contender.model, start.trials, threads),
        space(contender.definition.free),
        problem(predictor, space, start.segments, start.noise) {}
  TrialPredictor predictor;
  ParameterSpace space;
  ShootingProblem problem;
};

/// Least squares under sensor noise alone, to begin with.
void settle(BaseBench& bench, BaseSolution& base) {
  const FitPoint start{bench.space.clamp(bench.space.to_coordinates(base.values)), base.states};
  LeastSquaresOptions options;
  options.loss = {3.0};
  options.max_iterations = 10;
  options.tolerance = 1e-4;
  const LeastSquaresResult search = minimize(bench.problem, start, options);
  if (!search.valid) throw Error("the fitted model cannot be simulated: " + bench.problem.last_reason());
  base.values = bench.space.to_values(search.point.values);
  base.states = search.point.states;
}

void linearise(BaseBench& bench, const RowBins& bins, BaseSolution& base) {
  const FitPoint point{bench.space.to_coordinates(base.values), base.states};
  std::vector<Eigen::VectorXd> residuals;
  if (!bench.problem.residuals(point, residuals))
    throw Error("the fitted model cannot be simulated: " + bench.problem.last_reason());
  base.linear = linear_segments(bench.problem, bins, point, residuals);
  base.residual = rms(base.linear);
  base.steps = bench.problem.steps();
}

/// The linear segments with the nuisances that the refit has inside their bounds: taken off the residual, and beside
/// the values. What is at its bound is taken off alone.
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

std::vector<std::vector<Probe>> all_probes(const Round& round, int threads) {
  const std::map<std::string, double> scales = data_scales(round.base.trials);
  std::vector<std::vector<Probe>> probes(round.hypotheses.size());
  parallel_for(probes.size(), threads, [&](std::size_t h, int) {
    throw_if_interrupted();
    probes[h] = find_probes(round.hypotheses[h], round.base, round.bins, scales);
  });
  return probes;
}

/// Random forces that the experiment file declares are at least there: as white pulses with the same power at low
/// frequencies.
void require_declared(const Contender& contender, Round& round) {
  const NoiseSection& declared = contender.experiment.noise;
  const double step = contender.definition.engine.step;
  const double time = declared.process_correlation_time > 0.0 ? 2.0 * declared.process_correlation_time : step;
  for (const DisturbedJoint& joint : disturbed_joints(contender.definition.structure.robot, declared))
    for (std::size_t j = 0; j < round.forces.joints.size(); ++j)
      if (round.forces.joints[j] == joint.joint)
        round.noise.require_force(j, joint.deviation * std::sqrt(time / round.forces.width));
}

/// By segment: all probes beside each other, and the free force's functions.
std::vector<Eigen::MatrixXd> columns_of(const Round& round, const std::vector<std::vector<Probe>>& probes,
                                        const FreeForce& force) {
  std::vector<Eigen::MatrixXd> columns;
  for (std::size_t k = 0; k < round.base.linear.size(); ++k) {
    std::vector<Eigen::VectorXd> all;
    for (const std::vector<Probe>& of : probes)
      for (const Probe& probe : of) all.push_back(probe.response[k]);
    if (!round.base.nuisance.empty()) all.emplace_back(round.base.nuisance[k].col(0));
    if (!force.empty())
      for (Eigen::Index i = 0; i < force.columns[k].cols(); ++i) all.emplace_back(force.columns[k].col(i));
    Eigen::MatrixXd matrix(round.base.linear[k].residual.size(), static_cast<Eigen::Index>(all.size()));
    for (std::size_t i = 0; i < all.size(); ++i) matrix.col(static_cast<Eigen::Index>(i)) = all[i];
    columns.push_back(std::move(matrix));
  }
  return columns;
}

/// Hypotheses worth a refit, best score first, each with the probes that it starts from.
std::vector<std::pair<std::size_t, std::vector<ProbeScore>>> shortlist(const Screening& screening) {
  std::vector<std::pair<std::size_t, std::vector<ProbeScore>>> list;
  for (const ProbeScore& score : screening.scores) {
    const auto known =
        std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.first == score.hypothesis; });
    if (known != list.end()) {
      if (known->second.size() < kStarts) known->second.push_back(score);
      continue;
    }
    const bool comparable = score.deviance >= kComparable * screening.scores.front().deviance;
    const bool by_chance = screening.p > kChance;
    if (list.size() < (by_chance ? kRefitsByChance : kFewestRefits) ||
        (comparable && !by_chance && list.size() < kMostRefits))
      list.push_back({score.hypothesis, {score}});
  }
  return list;
}

/// Share of the column's power that the others, without their starts, do not span.
double share_beside(const std::vector<Eigen::MatrixXd>& column, const std::vector<Eigen::MatrixXd>& others) {
  const Eigen::Index count = others.front().cols();
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd mixed = Eigen::VectorXd::Zero(count);
  double power = 0.0;
  for (std::size_t k = 0; k < column.size(); ++k) {
    gram += others[k].transpose() * others[k];
    mixed += others[k].transpose() * column[k].col(0);
    power += column[k].squaredNorm();
  }
  if (power <= 0.0) return 0.0;
  return 1.0 - mixed.dot(gram.completeOrthogonalDecomposition().solve(mixed)) / power;
}

constexpr double kAlike = 0.02;  ///< share below which a column is another one, scaled

/// The timing of commands, unless the model has a value that does the same.
std::vector<Eigen::MatrixXd> timing_beside(const Contender& contender, const Round& round, int threads) {
  std::vector<Eigen::MatrixXd> timing =
      timing_columns(*contender.model, contender.definition, round.base, round.bins, threads);
  if (timing.empty()) return timing;
  std::vector<Eigen::MatrixXd> values;
  for (const LinearSegment& segment : round.base.linear) values.push_back(segment.values);
  if (values.front().cols() > 0 && share_beside(timing, values) < kAlike) timing.clear();
  return timing;
}

/// The base that a hypothesis is refitted on: without a nuisance that does what the effect does.
BaseSolution base_for(const Round& round, const std::vector<Probe>& probes, const std::vector<ProbeScore>& scores) {
  BaseSolution base = round.base;
  if (base.nuisance.empty()) return base;
  const Probe& probe = probes[scores.front().probe];
  const std::vector<Eigen::MatrixXd> response(probe.response.begin(), probe.response.end());
  if (share_beside(response, base.nuisance) < kAlike) base.nuisance.clear();
  return base;
}

/// Values to start a refit from: the probe, and the probe scaled to the size that its score wants.
void add_starts(const Hypothesis& hypothesis, const Probe& probe, const ProbeScore& score,
                const std::vector<double>& base, std::vector<std::vector<double>>& starts) {
  starts.push_back(hypothesis.values(base, probe.own));
  const double size = std::clamp(score.size, probe.one_sided ? 0.1 : -3.0, 3.0);
  std::vector<double> scaled = hypothesis.neutral;
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    const FreeValue& free = hypothesis.definition.free[hypothesis.own[i]];
    if (free.scale == Scale::logarithmic)
      scaled[i] = probe.own[i];
    else
      scaled[i] = std::clamp(scaled[i] + size * (probe.own[i] - scaled[i]), free.lower, free.upper);
  }
  starts.push_back(hypothesis.values(base, scaled));
}

void refit_rivals(Round& round, const std::vector<std::vector<Probe>>& probes, int threads) {
  const auto list = shortlist(round.screening);
  round.rivals.resize(list.size());
  const auto fit = [&](std::size_t i, const std::vector<std::vector<double>>& starts,
                       const std::vector<Eigen::VectorXd>& states, int iterations) {
    const auto& [h, scores] = list[i];
    const Hypothesis& hypothesis = round.hypotheses[h];
    BaseSolution base = base_for(round, probes[h], scores);
    base.states = states;
    return refit({hypothesis.definition, *hypothesis.model, hypothesis.base}, base, round.bins, round.factors, starts,
                 1, {std::max(RefitEffort().precision, kFineEnough * scores.front().deviance), iterations});
  };
  parallel_for(list.size(), threads, [&](std::size_t i, int) {
    const auto& [h, scores] = list[i];
    std::vector<std::vector<double>> starts;
    for (const ProbeScore& score : scores)
      add_starts(round.hypotheses[h], probes[h][score.probe], score, round.base.values, starts);
    round.rivals[i] = {h, scores.front().deviance, fit(i, starts, round.base.states, kScoutIterations), {}, {}};
  });
  double best = round.fit.deviance;
  for (const Rival& rival : round.rivals)
    if (rival.fit.valid) best = std::min(best, rival.fit.deviance);
  const double reach = std::max(kFarDeviance, kFarBehind * (round.fit.deviance - best));
  parallel_for(list.size(), threads, [&](std::size_t i, int) {
    const Refit& scout = round.rivals[i].fit;
    if (!scout.valid || scout.converged || scout.deviance > best + reach) return;
    Refit further = fit(i, {scout.values}, scout.states, RefitEffort().iterations);
    if (further.valid) round.rivals[i].fit = std::move(further);
  });
}

}  // namespace

Round run_round(const RoundTask& task) {
  task.meter.begin_part("noise");
  BaseBench bench(task.contender, task.start, task.threads);
  Round round{RowBins(bench.problem, task.start.bin_widths)};
  round.base = task.start;
  round.base.values = task.contender.values;
  settle(bench, round.base);
  linearise(bench, round.bins, round.base);
  round.base.nuisance = timing_beside(task.contender, round, task.threads);
  if (round.base.free_run)
    round.base.doubts = contact_doubts(task.contender.definition, round.base, round.bins, task.threads);
  else
    round.forces = force_responses(task.contender.definition, bench.problem, round.bins,
                                   {bench.space.to_coordinates(round.base.values), round.base.states},
                                   round.base.values, round.base.residual, task.threads);
  round.noise = NoiseModel(round.bins, round.forces, round.base.doubts);
  require_declared(task.contender, round);
  round.folds = folds(round.base.segments);
  task.meter.end_part();

  task.meter.begin_part("screening");
  round.hypotheses =
      list_hypotheses(task.contender.experiment, task.catalog, task.contender.definition, task.among, round.untestable);
  const std::vector<std::vector<Probe>> probes = all_probes(round, task.threads);
  for (std::size_t h = 0; h < probes.size(); ++h)
    if (probes[h].empty())
      round.untestable.push_back(
          {round.hypotheses[h].entry.effect, round.hypotheses[h].where(), "nothing in these trials shows it"});
  const StartStates states(task.contender.definition.structure.robot, bench.predictor, round.base.noise);
  const std::vector<JointMotion> motions = joint_motions(round.base, task.contender.definition.structure.robot,
                                                         task.contender.model->coordinates(), states, round.forces);
  const FreeForce force = free_force(motions, round.forces);
  estimate_noise(round.noise, round.base.linear, columns_of(round, probes, force), task.threads);
  task.meter.end_part();

  task.meter.begin_part("refit of the model");
  round.factors = noise_factors(round.noise);
  std::vector<std::size_t> own_places(round.base.values.size());
  std::iota(own_places.begin(), own_places.end(), std::size_t{0});
  round.fit = refit({task.contender.definition, *task.contender.model, own_places}, round.base, round.bins,
                    round.factors, {round.base.values}, task.threads);
  if (!round.fit.valid) throw Error("the model cannot be refitted: " + bench.problem.last_reason());
  round.base.values = round.fit.values;
  round.base.states = round.fit.states;
  linearise(bench, round.bins, round.base);
  round.held_out = held_out_deviance(round.fit, round.folds);
  const WhitenedSegments whitened(round.noise, with_nuisance(round.base, round.fit));
  round.screening = screen(whitened, probes, task.seed);
  round.free_force = test_free_force(whitened, force, round.folds);
  if (force.empty()) round.free_force.held_out = round.held_out;
  if (round.free_force.p < kFreeForceLevel)
    round.formulas = find_formulas(whitened, motions, round.forces, round.folds, task.seed);
  task.meter.end_part();

  task.meter.begin_part("refits of candidates");
  refit_rivals(round, probes, task.threads);
  for (Rival& rival : round.rivals) {
    if (!rival.fit.valid) continue;
    rival.held_out = held_out_deviance(rival.fit, round.folds);
    rival.gain = gain(round.held_out, rival.held_out, task.seed);
  }
  std::erase_if(round.rivals, [](const Rival& rival) { return !rival.fit.valid; });
  std::stable_sort(round.rivals.begin(), round.rivals.end(),
                   [](const Rival& a, const Rival& b) { return a.gain.value > b.gain.value; });
  task.meter.end_part();
  return round;
}

BaseSolution without_values(BaseSolution base) {
  base.steps.erase(base.steps.begin(), base.steps.begin() + static_cast<std::ptrdiff_t>(base.values.size()));
  base.values.clear();
  return base;
}

Refit refit_reduced(const Contender& less, const Round& round, int threads) {
  return refit({less.definition, *less.model, {}}, without_values(round.base), round.bins, round.factors, {less.values},
               threads);
}

}  // namespace lacuna
