#pragma once

#include "candidates/hypothesis.h"
#include "candidates/probe_sizes.h"
#include "search/fitted_models.h"
#include "search/probed_laws.h"

#include <memory>
#include <string>
#include <vector>

namespace lacuna {

/// What one effect beside a fitted model promises to first order.
struct EffectPromise {
  std::size_t hypothesis = 0;
  double cost = 0.0;               ///< that is left, nats
  std::vector<SizedProbe> probes;  ///< of the effect's values: alike but for the one that each was sized by
  Eigen::VectorXd step;            ///< of the model's values, then times each probe
  Eigen::VectorXd gains = {};      ///< nats by block of time, cross-fitted
};

struct LookStage;

/// The whole library beside one fitted model.
struct EffectLook {
  std::vector<Hypothesis> hypotheses;
  std::vector<Untestable> untestable;
  std::vector<EffectPromise> promises;  ///< the least cost first
  double cost = 0.0;                    ///< of the model itself
  std::vector<Eigen::VectorXd> gains;   ///< nats by block of time, cross-fitted: of every law that was looked at
  std::shared_ptr<const LookStage> stage;
  std::shared_ptr<const std::vector<std::vector<ProbeResponse>>> responses;  ///< by hypothesis
};

EffectLook look_at_library(const SearchData& data, const FittedModel& model, const PredictionLadder& ladder);

/// The same beside another model, by what the effects changed in the first look: no effect is simulated.
EffectLook look_beside(const SearchData& data, const FittedModel& model, const EffectLook& look);

/// Where a fit of the model with the effect begins: with the probe as it is or as large as it promises most, and with
/// the model's values as they are or moved along, whichever costs least in truth.
NamedValues start_of_fit(const SearchData& data, const FittedModel& model, const EffectLook& look,
                         const EffectPromise& promise);

/// Whether two effects do alike things at one place, by what either declares.
bool of_one_kind(const Hypothesis& one, const Hypothesis& other);

}  // namespace lacuna
