#pragma once

#include "diagnosis/base_solution.h"
#include "evaluation/model_definition.h"
#include "evaluation/trial_predictor.h"

#include <memory>

namespace lacuna {

/// Coarser steps, for simulations whose differences alone are wanted: derivatives, pulses of a force, sizes. Both
/// sides of a difference have the same error of integration, and what stays of it is to the difference as that error is
/// to the prediction; but not where bodies may hit the ground, whose settings are the model's own.
EngineSettings for_differences(const ModelDefinition& definition);

/// Simulates a model with such steps.
class RoughPredictor {
 public:
  /// Of `base` the trials are copied. A simulation through contacts has no such differences, and steps that are as
  /// coarse as can be no coarser ones: there is no predictor then.
  RoughPredictor(const ModelDefinition& definition, const BaseSolution& base, int workers,
                 Timing timing = Timing::as_recorded);

  /// Null if there is none.
  const TrialPredictor* predictor() const { return predictor_.get(); }

 private:
  std::unique_ptr<CompiledModel> model_;
  std::unique_ptr<TrialPredictor> predictor_;
};

}  // namespace lacuna
