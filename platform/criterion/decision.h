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
  Eigen::VectorXd mean_square;  ///< by cell, of whitened residuals where it was fitted
  std::set<std::string> idle;   ///< members that the data do not tell from ones that do nothing
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

/// Of the error of the model as it is, the share that one set takes which another one leaves: the root of the
/// difference of their mean squares over the model's, at the length and joint where that is largest. `over` leaves
/// more.
double share_of_error(const CandidateSet& set, const CandidateSet& over, const CandidateSet& model);

/// Whether what a set has more than `over` is a minor matter: it takes less than a fifth of the model's error, and
/// makes less than two fifths of `whole_gain`, nats. It is none where errors are at the noise with it and not without:
/// then nothing is left that it could stand for.
bool is_minor(const CandidateSet& set, const CandidateSet& over, const CandidateSet& model, double whole_gain);

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
  std::size_t best = 0;    ///< the one that gains most of those that may be the answer: minor effects with it
  /// Other sets, of as many told values, that are indistinguishable from it on these data; none that holds it.
  std::vector<std::size_t> alike;
  double p = 1.0;              ///< how often chance alone would gain as much as the best set does
  std::set<std::string> idle;  ///< effects that lower the error, too, but were left out because they may do nothing
  CostGain gain;               ///< of the answer over the model as it is
  double whole_gain = 0.0;     ///< nats, the largest of any set
};

/// `sets`: the model as it is first. Something is present where the signs of the gains of all sets, and of all that was
/// looked at, say so at 5 %, the best gains more than its error, at more than one length, and lowers the error by a
/// twentieth at one. A set of one more effect must pass the same against the best smaller one. Of the sets of at most
/// as many told values that one is looked for which gains most once every told value is paid for; then, of those that
/// gain as much but for a twentieth, the best of the fewest told values. The answer is its part without effects that
/// may do nothing, or that take less than a fifth of the error and two fifths of the gain, unless errors are at the
/// noise by them alone; where it has none, of others as good, within a twentieth of the gain or one standard error,
/// with as many told values, the one of fewest values in all, then of fewest members, then of fewest effects: friction
/// in three joints is one thing.
Decision decide(const std::vector<CandidateSet>& sets, const std::vector<LookedBeside>& looked, std::uint64_t seed);

}  // namespace lacuna
