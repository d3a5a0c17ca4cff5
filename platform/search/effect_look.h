#pragma once

#include "candidates/hypothesis.h"
#include "candidates/probe_sizes.h"
#include "search/fitted_models.h"
#include "search/probed_laws.h"

#include <memory>
#include <string>
#include <vector>

namespace lacuna {

/// The first-order prediction of the gain by one effect beside a fitted model.
struct EffectPromise {
  std::size_t hypothesis = 0;
  double cost = 0.0;               ///< cost with the effect, nats
  std::vector<SizedProbe> probes;  ///< of the effect's values; they differ only in the parameter that was sized
  Eigen::VectorXd step;            ///< step of the model's values, then the factor of each probe
  Eigen::VectorXd gains = {};      ///< nats by block of time, cross-fitted
};

struct LookStage;

/// First-order gains of the whole library beside one fitted model.
struct EffectLook {
  std::vector<Hypothesis> hypotheses;
  std::vector<Untestable> untestable;
  std::vector<EffectPromise> promises;  ///< the least cost first
  double cost = 0.0;                    ///< of the model itself
  std::vector<Eigen::VectorXd> gains;   ///< nats by block of time, cross-fitted: of every law examined
  std::shared_ptr<const LookStage> stage;
  std::shared_ptr<const std::vector<std::vector<ProbeResponse>>> responses;  ///< by hypothesis
};

EffectLook look_at_library(const SearchData& data, const FittedModel& model, const PredictionLadder& ladder);

/// The same beside another model, with the responses of the first one: no effect is simulated again.
EffectLook look_beside(const SearchData& data, const FittedModel& model, const EffectLook& look);

/// The start of a fit of the model with the effect: the probe at its own or its predicted size, and the model's values
/// with or without their predicted step; of these the one with the lowest simulated cost.
NamedValues start_of_fit(const SearchData& data, const FittedModel& model, const EffectLook& look,
                         const EffectPromise& promise);

/// Whether two effects act alike at one place, according to the declaration of either.
bool of_one_kind(const Hypothesis& one, const Hypothesis& other);

}  // namespace lacuna
