#pragma once

#include "search/effect_look.h"
#include "search/fitted_models.h"

#include <vector>

namespace lacuna {

inline constexpr std::size_t kMostMembers = 3;  ///< of a set
inline constexpr double kWorthATriple = 0.05;   ///< of the whole gain, which a pair must add
inline constexpr double kSame = 0.1;  ///< of the gain by blocks of time: two sets closer than this do the same

/// Members of one model: "b" beside "a".
using Entries = std::vector<EffectEntry>;

Entries without_member(const Entries& added, std::size_t member);
/// Whether an effect with a value for each joint is beside itself on one of them.
bool is_twice(const Entries& added, const RobotSpec& robot);

/// The sets that a search has fitted so far, in order and compared. Pointers last until the set is fitted again.
class FittedSets {
 public:
  /// `models` and `look`, at the library beside the model as it is, must outlive this; both may grow.
  FittedSets(const FittedModels& models, const EffectLook& look) : models_(models), look_(look) {}

  /// The model as it is first, then the sets of at most three members.
  std::vector<const FittedModel*> candidates() const;
  /// As the decision sees them.
  std::vector<CandidateSet> judged() const;
  /// The sets of a size by decreasing gain on data to which they were not fitted, less the price of their values.
  std::vector<const FittedModel*> ordered(std::size_t size) const;
  /// The one with the least cost on data to which it was not fitted.
  const FittedModel* best() const;
  /// nats, the largest of all sets.
  double whole_gain() const;
  /// Whether two sets gain the same in every block of time.
  bool does_the_same(const FittedModel& one, const FittedModel& other) const;
  /// Whether a pair gains more than each of its effects alone.
  bool gains_by_both(const FittedModel& pair) const;

 private:
  const FittedModels& models_;
  const EffectLook& look_;
};

}  // namespace lacuna
