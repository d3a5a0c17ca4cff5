#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "search/look.h"
#include "search/model_set.h"

namespace lacuna {

/// A fitted set as it is ranked.
struct RankedSet {
  Contender model;             ///< `values` with the timing last, where that is fitted
  Eigen::MatrixXd covariance;  ///< of the values' coordinates
  double cost = 0.0;           ///< nats
  HorizonErrors errors, held_out;
  CostDifference over_answer;  ///< what it costs more than the answer
  CostDifference over_base;    ///< what the model as it is costs more than it
};

/// An effect that recordings which nothing was fitted to speak against.
struct NotConfirmed {
  std::string effect;    ///< "name @ where"
  double with_it = 0.0;  ///< error of the held-out predictions over the model's as it is, geometric mean
  double without = 0.0;
};

struct Missing {
  bool stopped = false;            ///< by the time limit: of what was fitted until then
  std::set<std::string> examined;  ///< effects that were fitted, "name @ where"
  std::optional<RankedSet>
      look_alike;  ///< the best set with another effect in the place of one of the answer's, which does the same
  std::vector<NotConfirmed> not_confirmed;  ///< left out of the answer again
  std::set<std::string> alike;              ///< effects that do in the place of one of the answer's what it does
  std::size_t hypotheses = 0;               ///< effect × place
  std::vector<Untestable> untestable;
  bool timing = false;             ///< when commands act was fitted
  std::vector<RankedSet> ranking;  ///< the least cost first
  std::size_t answer = 0;          ///< of the ranking: the smallest set that is as good as the best
  RankedSet base;
  Ladder ladder;
  int refits = 0;
};

/// Mean over rungs and channels of the error over its floor, in proportion.
double times_floor(const Ladder& ladder, const HorizonErrors& errors);
/// The same of that rung and channel where it is most.
double most_times_floor(const Ladder& ladder, const HorizonErrors& errors);

/// Throws `Interrupted`. Where the time limit is reached it is lifted, and the search `stopped`.
Missing find_missing(const Ground& ground);

}  // namespace lacuna
