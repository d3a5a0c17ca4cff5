#pragma once

#include "diagnosis/screening/probe_sizes.h"
#include "search/ground.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// What adding one effect promises, to first order, beside a fitted model.
struct Promise {
  std::size_t hypothesis = 0;
  double cost = 0.0;                           ///< that is left, nats
  std::vector<double> values;                  ///< of the model with it: where a fit of it begins
  std::optional<std::vector<double>> plainly;  ///< the same where what shapes the effect has no value yet
};

/// The same of two effects at once.
struct PairPromise {
  std::size_t one = 0, other = 0;  ///< hypotheses
  double cost = 0.0;
  std::vector<double> base;              ///< of the model's own values
  std::vector<double> of_one, of_other;  ///< of the effects' own values
};

/// The probes by which each effect promised most, by "name @ where".
using KnownProbes = std::map<std::string, std::vector<SizedProbe>>;

/// The whole library beside one fitted model, without a fit of any of it.
struct Look {
  std::vector<Hypothesis> hypotheses;
  std::vector<Untestable> untestable;
  std::vector<Promise> promises;   ///< the least cost first
  std::vector<PairPromise> pairs;  ///< where asked for: those that promise most more than either alone
  KnownProbes probes;
  double cost = 0.0;  ///< of the model on the same segments
};

/// `fit`: of `model`, on the whole ladder. `known`: of an earlier look, so that nothing need be sized again; null:
/// none.
Look look_beside(const Ground& ground, const Contender& model, const HorizonFit& fit,
                 const KnownProbes* known = nullptr, std::size_t pairs = 0);

}  // namespace lacuna
