#include "diagnosis/sufficient_substeps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace lacuna {
namespace {

/// Of the sensor noise, by which twice as many substeps may change the prediction. What of it a round's model makes is
/// taken off the data; that another model makes a few hundredths less or more is all that stays.
constexpr double kTolerated = 2.0;

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
  const int most = definition.engine.substeps;
  for (int substeps = 1; substeps < most;) {
    const double change = rms_change(residuals_with(substeps, definition, base, threads),
                                     residuals_with(2 * substeps, definition, base, threads));
    if (change <= kTolerated) return substeps;
    const double wanted = std::ceil(substeps * change / kTolerated);  // the error is of first order
    substeps = std::max(substeps + 1, static_cast<int>(std::min(wanted, 2.0 * substeps)));
  }
  return most;
}

}  // namespace lacuna
