#pragma once

#include "criterion/cost.h"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace lacuna {

/// A fitted set of effects as the decision sees it.
struct CandidateSet {
  std::set<std::string> members;  ///< "effect @ place"; none: the model as it is
  int told = 0;                   ///< values of the members that the data tell
  int values = 0;                 ///< of the members, all
  CrossFittedCost cost;
  double share_to_add = 0.05;  ///< of the whole gain, that it must gain over the best smaller set
};

/// By how much one set costs less than another, nats, with its standard error.
struct CostGain {
  double nats = 0.0;
  double error = 0.0;

  bool is_told() const { return nats > error; }
};

CostGain gain_of(const CandidateSet& set, const CandidateSet& over);
/// The same without the length at which most is gained.
CostGain gain_elsewhere(const CandidateSet& set, const CandidateSet& over);

/// The gain at the length at which it is largest, nats of that length's own cost.
double largest_gain(const CandidateSet& set, const CandidateSet& over);

/// Laws that were looked at beside a set and mostly not fitted: what chance has had to choose from.
struct LookedBeside {
  std::set<std::string> members;       ///< of the set
  std::vector<Eigen::VectorXd> gains;  ///< of each law over the set, by block of time, nats
};

/// What is missing.
struct Decision {
  std::size_t answer = 0;  ///< which of the sets
  /// Other sets, of as many told values, that are indistinguishable from it on these data; none that holds it.
  std::vector<std::size_t> alike;
  double p = 1.0;           ///< how often chance alone would gain as much as the best set does
  CostGain gain;            ///< of the answer over the model as it is
  double whole_gain = 0.0;  ///< nats, the largest of any set
};

/// `sets`: the model as it is first. Something is present where the signs of the gains of all sets, and of all that was
/// looked at, say so at 5 %, the best
/// gains more than its error, at more than one length, and lowers the error by a twentieth at one. A set of one more
/// effect must pass the same against the best smaller one, and add its share of the whole gain. Of the sets that are as
/// good as the largest that passes, within a twentieth of it or one standard error, the answer is the one of fewest
/// told values, of several such the one of fewest in all, then of fewest effects.
Decision decide(const std::vector<CandidateSet>& sets, const std::vector<LookedBeside>& looked, std::uint64_t seed);

}  // namespace lacuna
