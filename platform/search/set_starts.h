#pragma once

#include "search/look.h"
#include "search/model_set.h"

namespace lacuna {

/// A model with a set of effects, and from where its fit begins.
struct StartedSet {
  Contender model;
  std::vector<Starts> ways;
};

/// A set with the effect of a promise beside it. An effect whose shape has no value yet has a second way.
StartedSet with_promised(const Ground& ground, const FittedSet& parent, const Look& look, const Promise& promise);

/// Two effects that promise most together.
StartedSet with_promised(const Ground& ground, const Look& look, const PairPromise& pair);

/// Two effects that were fitted alone; what the model has beside them stays as the better one has it.
StartedSet with_both(const Ground& ground, const FittedSet& better, const FittedSet& other);

/// A set with a simpler effect of the same kind in the place of one of its effects: it begins as the other ended, with
/// those of its values that both have.
StartedSet with_simpler(const Ground& ground, const FittedSet& set, std::size_t member, const Hypothesis& simpler);

}  // namespace lacuna
