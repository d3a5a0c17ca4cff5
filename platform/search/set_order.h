#pragma once

#include "search/model_set.h"

#include <set>

namespace lacuna {

inline constexpr double kRelevant = 0.10;  ///< of what the best set gains: what each value of an effect must gain

/// In which order fitted sets are preferred: by what they cost where they were not fitted, and by how much each value
/// that they have more than the model must earn. `sets` must outlive it.
class SetOrder {
 public:
  explicit SetOrder(const ModelSets& sets) : sets_(sets) {}

  /// Nats, of the set that costs least, over the model as it is.
  double largest_gain() const;
  /// What a set costs with what its values must earn: an effect that earns less makes up for the form of another one. A
  /// value that the data do not tell must earn a little. `gain`: of the best set.
  double with_size(const FittedSet& set, double gain) const;
  /// Names of the sets of so many effects, the best first; those that have more values than the data tell are left out.
  std::vector<std::string> best_of(std::size_t size, std::size_t most) const;

 private:
  const FittedSet& base() const { return *sets_.find(""); }
  bool is_told(const FittedSet& set) const;

  const ModelSets& sets_;
};

/// "effect @ where" of each.
std::set<std::string> effects_of(const FittedSet& set);

/// Whether a set has another effect in the place of one of the answer's and costs no more than the difference's error.
/// Of sets that were not fitted to all segments the costs on some of them are compared.
bool does_the_same(const FittedSet& set, const FittedSet& answer);

}  // namespace lacuna
