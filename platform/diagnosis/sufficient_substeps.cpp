#include "diagnosis/sufficient_substeps.h"

#include <cmath>
#include <limits>
#include <optional>

namespace lacuna {
namespace {

constexpr double kTolerated = 1.0;  ///< of the sensor noise

using Residuals = std::optional<std::vector<Eigen::VectorXd>>;

Residuals residuals_with(int substeps, const ModelDefinition& definition, const BaseSolution& base, int threads) {
  EngineSettings engine = definition.engine;
  engine.substeps = substeps;
  const std::unique_ptr<CompiledModel> model = compile(definition.structure, engine);
  const TrialPredictor predictor(*model, base.trials, threads);
  const ParameterSpace space(definition.free);
  ShootingProblem problem(predictor, space, base.segments, base.noise);
  std::vector<Eigen::VectorXd> residuals;
  if (!problem.residuals({space.to_coordinates(base.values), base.states}, residuals)) return std::nullopt;
  return residuals;
}

double rms_change(const Residuals& a, const Residuals& b) {
  if (!a || !b) return std::numeric_limits<double>::infinity();
  double squares = 0.0, count = 0.0;
  for (std::size_t k = 0; k < a->size(); ++k) {
    squares += ((*a)[k] - (*b)[k]).squaredNorm();
    count += static_cast<double>((*a)[k].size());
  }
  return std::sqrt(squares / count);
}

}  // namespace

int sufficient_substeps(const ModelDefinition& definition, const BaseSolution& base, int threads) {
  if (base.free_run) return definition.engine.substeps;
  int substeps = 1;
  Residuals coarse = residuals_with(substeps, definition, base, threads);
  while (substeps < definition.engine.substeps) {
    Residuals fine = residuals_with(2 * substeps, definition, base, threads);
    if (rms_change(coarse, fine) <= kTolerated) return substeps;
    substeps *= 2;
    coarse = std::move(fine);
  }
  return definition.engine.substeps;
}

}  // namespace lacuna
