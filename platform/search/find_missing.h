#pragma once

#include "search/look.h"
#include "search/model_set.h"

namespace lacuna {

/// A fitted set as it is ranked.
struct RankedSet {
  std::vector<EffectEntry> effects;
  std::vector<double> values;  ///< of the model with them, SI
  double cost = 0.0;           ///< nats
  HorizonErrors errors, held_out;
  CostDifference over_answer;  ///< what it costs more than the answer
  double p_by_chance = 1.0;    ///< of its last effect beside the others
};

struct Missing {
  std::vector<RankedSet> ranking;  ///< the least cost first
  std::size_t answer = 0;          ///< of the ranking: the smallest set that is as good as the best
  RankedSet base;
  Ladder ladder;
  int refits = 0;
};

Missing find_missing(const MissingTask& task);

}  // namespace lacuna
