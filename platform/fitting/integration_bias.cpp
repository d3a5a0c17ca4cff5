#include "fitting/integration_bias.h"

#include "fitting/fitted_values.h"
#include "fitting/shooting/reduced_rows.h"
#include "fitting/stages.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr std::size_t kApproachSegments = 96;
constexpr int kApproachIterations = 10;  ///< a stage
constexpr int kLastIterations = 3;

EngineSettings with_substeps(EngineSettings engine, int substeps) {
  engine.substeps = substeps;
  return engine;
}

/// The stages of a fit by multiple shooting, the last one at the end.
std::vector<PlannedStage> shooting_stages(FitSection options, const TrialPredictor& predictor,
                                          const StartStates& states) {
  options.method = "multiple_shooting";
  std::vector<std::string> notes;
  return plan_stages(options, predictor, states, notes);
}

}  // namespace

/// A model with a number of substeps, and the trials at it.
struct IntegrationBias::Solution {
  Solution(const ModelDefinition& definition, int substeps, const std::vector<Trial>& trials, const Work& work)
      : model(compile(definition.structure, with_substeps(definition.engine, substeps))),
        predictor(*model, trials, work) {}

  std::unique_ptr<CompiledModel> model;
  TrialPredictor predictor;
};

IntegrationBias::IntegrationBias(const ModelDefinition& definition, const FitSection& options,
                                 const std::vector<Trial>& trials, std::size_t all, std::vector<double> values,
                                 int substeps, const Work& work)
    : definition_(definition),
      space_(definition.free),
      noise_(sensor_noise(definition.structure.robot, trials)),
      work_(work),
      trials_share_(static_cast<double>(trials.size()) / static_cast<double>(all)),
      loss_(options.loss == "huber" ? RobustLoss{options.loss_scale} : RobustLoss{}),
      base_(std::make_unique<Solution>(definition, substeps, trials, work)) {
  if (!approach(options, std::move(values))) {
    problem_.reset();
    return;
  }
  std::vector<bool> at_bound;
  for (Eigen::Index j = 0; j < space_.size(); ++j) at_bound.push_back(bound_side(space_, point_.values, j) != 0);
  problem_->linearize(point_, at_base_, jacobians_);
  known_ = uncertainty(*problem_, space_, point_, at_base_, jacobians_, loss_, at_bound);
}

IntegrationBias::~IntegrationBias() = default;

bool IntegrationBias::approach(const FitSection& options, std::vector<double> values) {
  const StartStates states(definition_.structure.robot, base_->predictor, noise_);
  std::vector<PlannedStage> stages = shooting_stages(options, base_->predictor, states);
  for (PlannedStage& stage : stages) {
    const bool last = &stage == &stages.back();
    if (stage.automatic) {
      const double horizon = automatic_horizon(base_->predictor, states, values, kHead);
      stage.length = std::isfinite(horizon) ? std::max(horizon, kHead) : 0.0;
    }
    std::vector<Segment> segments = make_segments(base_->predictor, states, stage.length, values);
    if (!last) segments = thinned(std::move(segments), kApproachSegments);
    if (segments.empty()) continue;
    problem_ = std::make_unique<ShootingProblem>(base_->predictor, space_, std::move(segments), noise_);
    Candidate found = refine(*problem_, space_.to_coordinates(values),
                             {loss_, last ? kLastIterations : kApproachIterations, kCoarse});
    if (found.valid) values = space_.to_values(found.values);
    if (!last) continue;
    if (found.valid) problem_->set_scales(found.scales);
    point_ = std::move(found.search.point);
    at_base_ = std::move(found.search.residuals);
    return found.valid;
  }
  return false;
}

std::vector<Eigen::VectorXd> IntegrationBias::residuals(int substeps) const {
  const Solution solution(definition_, substeps, base_->predictor.trials(), work_);
  ShootingProblem problem(*problem_, solution.predictor);
  std::vector<Eigen::VectorXd> found;
  if (!problem.residuals(point_, found)) found.clear();
  return found;
}

std::optional<ValueShift> IntegrationBias::with(int substeps) const {
  if (!problem_) return std::nullopt;
  const std::vector<Eigen::VectorXd> coarse = residuals(substeps), fine = residuals(2 * substeps);
  if (coarse.empty() || fine.empty()) return std::nullopt;
  const std::vector<ReducedRows> rows = reduce(*problem_, at_base_, jacobians_, loss_);
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(space_.size());
  for (std::size_t k = 0; k < rows.size(); ++k)
    pull += rows[k].sensitivity.transpose() * rows[k].curvature.asDiagonal() * (fine[k] - coarse[k]);
  return largest(known_.inverse_information * pull *
                 (4.0 / 3.0));  // with half the step, a quarter of the error remains
}

/// Correlated residuals widen an interval; the rest is at least as wide as for independent ones.
ValueShift IntegrationBias::largest(const Eigen::VectorXd& shifts) const {
  ValueShift most;
  for (Eigen::Index j = 0; j < shifts.size(); ++j) {
    const double variance = std::fmax(known_.covariance(j, j), known_.inverse_information(j, j)) * trials_share_;
    const double share = std::abs(shifts(j)) / (known_.quantile * std::sqrt(variance));
    if (std::isfinite(share) && share > most.share)
      most = {definition_.free[static_cast<std::size_t>(j)].address, share};
  }
  return most;
}

}  // namespace lacuna
