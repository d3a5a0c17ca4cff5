#pragma once

#include "search/model_set.h"

#include <set>
#include <string>
#include <vector>

namespace lacuna {

inline constexpr double kRelevant = 0.10;  ///< of what the best set gains: what each value of an effect must gain

enum class Segments { few, all };

/// In which order sets are preferred: by what they cost, and by how much each value that they have more than the model
/// must earn. Sets that are fitted to all segments cost what they cost where they were not fitted; on few segments,
/// which only lead to those, what they cost there. `sets` must outlive it.
class SetOrder {
 public:
  SetOrder(const FittedSets& sets, Segments segments) : sets_(sets), segments_(segments) {}

  /// What the set costs.
  double cost(const std::string& name) const { return cost(sets_.at(name)); }
  /// Nats, of the set that costs least, over the model as it is.
  double largest_gain() const;
  /// What a set costs with what its values must earn: an effect that earns less makes up for the form of another one. A
  /// value that the data do not tell must earn a little. `gain`: of the best set.
  double with_size(const FittedSet& set, double gain) const;
  /// Names of all sets in this order, the best first: those that have more values than the data tell are left out, and
  /// of sets that do the same all but one.
  std::vector<std::string> ordered() const;
  /// Of these names the first in this order.
  std::vector<std::string> best_among(const std::vector<std::string>& names, std::size_t most) const;
  /// Of so many effects.
  std::vector<std::string> best_of(std::size_t size, std::size_t most) const;

 private:
  bool is_fitted(const FittedSet& set) const;
  double cost(const FittedSet& set) const;
  bool is_told(const FittedSet& set) const;

  const FittedSet& base() const { return sets_.at(""); }

  const FittedSets& sets_;
  Segments segments_;
};

/// "effect @ where" of each.
std::set<std::string> effects_of(const FittedSet& set);

/// Whether a set has another effect in the place of one of the answer's and costs no more than the difference's error.
/// Of sets that were not fitted to all segments the costs on some of them are compared.
bool does_the_same(const FittedSet& set, const FittedSet& answer);

}  // namespace lacuna
