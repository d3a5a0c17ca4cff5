#include "diagnosis/rounds/round.h"

#include "diagnosis/candidates/data_scales.h"
#include "diagnosis/noise/contact_doubt.h"
#include "diagnosis/refit/timing.h"
#include "diagnosis/rounds/base_bench.h"
#include "diagnosis/rounds/fit_rivals.h"
#include "fitting/disturbance.h"
#include "foundation/interrupt.h"
#include "foundation/parallel.h"

#include <cmath>
#include <numeric>

namespace lacuna {
namespace {

/// `failures`: by hypothesis, why its last simulation that failed did.
std::vector<std::vector<Probe>> all_probes(const Round& round, int threads, std::vector<std::string>& failures) {
  const std::map<std::string, double> scales = data_scales(round.base.trials);
  std::vector<std::vector<Probe>> probes(round.hypotheses.size());
  failures.assign(round.hypotheses.size(), {});
  parallel_for(probes.size(), threads, [&](std::size_t h, int) {
    throw_if_interrupted();
    probes[h] = find_probes(round.hypotheses[h], round.base, round.bins, scales, failures[h]);
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

/// By segment: all probes beside each other, the timing, and the free force's functions.
std::vector<Eigen::MatrixXd> columns_of(const Round& round, const std::vector<std::vector<Probe>>& probes,
                                        const FreeForce& force) {
  std::vector<Eigen::MatrixXd> columns;
  for (std::size_t k = 0; k < round.base.linear.size(); ++k) {
    std::vector<Eigen::VectorXd> all;
    for (const std::vector<Probe>& of : probes)
      for (const Probe& probe : of) all.push_back(probe.response[k]);
    if (round.base.timing) all.push_back(round.base.by_timing[k]);
    if (!force.empty())
      for (Eigen::Index i = 0; i < force.columns[k].cols(); ++i) all.emplace_back(force.columns[k].col(i));
    Eigen::MatrixXd matrix(round.base.linear[k].residual.size(), static_cast<Eigen::Index>(all.size()));
    for (std::size_t i = 0; i < all.size(); ++i) matrix.col(static_cast<Eigen::Index>(i)) = all[i];
    columns.push_back(std::move(matrix));
  }
  return columns;
}

/// The parts of a round, in their order.
class Look {
 public:
  explicit Look(const RoundTask& task)
      : task_(task),
        model_(task.contender),
        bench_(task.contender, task.start, task.threads),
        round_{RowBins(bench_.problem(), task.start.bin_widths)} {}

  Round run() {
    part("noise", [&] { list_noises(); });
    part("screening", [&] { probe_all(); });
    part("refit of the model", [&] { judge_model(); });
    part("refits of candidates", [&] { fit_rivals(round_, probes_, task_.seed, task_.threads); });
    return std::move(round_);
  }

 private:
  template <class Work>
  void part(const char* what, const Work& work) {
    task_.meter.begin_part(what);
    work();
    task_.meter.end_part();
  }

  void list_noises() {
    BaseSolution& base = round_.base;
    base = task_.start;
    bench_.settle(base, task_.moving);
    bench_.linearise(round_.bins, base);
    if (!base.timing && longest_command_interval(base.trials) > 0.0) base.timing = 0.0;
    linearise_timing(model_, round_.bins, task_.threads, base);
    if (base.free_run)
      base.doubts = contact_doubts(model_.definition, base, round_.bins, task_.threads);
    else
      round_.forces = force_responses(model_.definition, bench_.problem(), round_.bins, bench_.point(base), base.values,
                                      base.residual, task_.threads);
    round_.noise = NoiseModel(round_.bins, round_.forces, base.doubts);
    require_declared(model_, round_);
    round_.folds = folds(base.segments, round_.bins);
  }

  void probe_all() {
    const RobotSpec& robot = model_.definition.structure.robot;
    round_.hypotheses =
        list_hypotheses(model_.experiment, task_.catalog, model_.definition, task_.among, round_.untestable);
    std::vector<std::string> failures;
    probes_ = all_probes(round_, task_.threads, failures);
    for (std::size_t h = 0; h < probes_.size(); ++h)
      if (probes_[h].empty()) round_.untestable.push_back(without_probes(round_.hypotheses[h], failures[h]));
    const StartStates states(robot, bench_.predictor(), round_.base.noise);
    motions_ = joint_motions(round_.base, robot, model_.model->coordinates(), states, round_.forces);
    force_ = free_force(motions_, round_.forces);
    estimate_noise(round_.noise, round_.base.linear, columns_of(round_, probes_, force_), task_.threads);
  }

  void judge_model() {
    refit_model();
    const bool held = round_.base.timing && round_.fit.at_bound.back();
    const WhitenedSegments whitened(round_.noise, beside_timing(round_.base, held));
    round_.screening = screen(whitened, probes_, task_.seed);
    const ForceTask beside{round_.fit, round_.factors, round_.folds, task_.seed};
    round_.free_force = test_free_force(beside, whitened, force_);
    if (round_.free_force.p < kFreeForceLevel) round_.formulas = find_formulas(beside, motions_, round_.forces);
  }

  void refit_model() {
    BaseSolution& base = round_.base;
    round_.factors = noise_factors(round_.noise);
    std::vector<std::size_t> own_places(base.values.size());
    std::iota(own_places.begin(), own_places.end(), std::size_t{0});
    const auto fit_again = [&] {
      return refit({model_.definition, *model_.model, own_places}, base, round_.bins, round_.factors, {base.values},
                   task_.threads);
    };
    round_.fit = fit_again();
    if (base.timing && round_.fit.valid && !tells_timing(round_.fit)) {
      base.timing.reset();
      round_.fit = fit_again();
    }
    if (!round_.fit.valid) throw Error("the model cannot be refitted: " + bench_.problem().last_reason());
    base.values = round_.fit.values;
    base.states = round_.fit.states;
    base.timing = round_.fit.timing;
    bench_.linearise(round_.bins, base);
    linearise_timing(model_, round_.bins, task_.threads, base);
    round_.held_out = held_out_deviance(round_.fit, round_.folds);
  }

  const RoundTask& task_;
  const Contender& model_;
  BaseBench bench_;
  Round round_;
  std::vector<std::vector<Probe>> probes_;  ///< by hypothesis
  std::vector<JointMotion> motions_;
  FreeForce force_;
};

}  // namespace

Round run_round(const RoundTask& task) { return Look(task).run(); }

BaseSolution without_values(BaseSolution base) {
  base.steps.erase(base.steps.begin(), base.steps.begin() + static_cast<std::ptrdiff_t>(base.values.size()));
  base.values.clear();
  return base;
}

Refit refit_under(const Round& round, const Contender& model, int threads, RefitEffort effort) {
  BaseSolution base = without_values(round.base);
  if (!base.timing && longest_command_interval(base.trials) > 0.0) base.timing = 0.0;
  return refit({model.definition, *model.model, {}}, base, round.bins, round.factors, {model.values}, threads, effort);
}

}  // namespace lacuna
