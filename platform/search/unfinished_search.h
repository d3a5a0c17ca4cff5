#pragma once

#include "diagnosis/rounds/search_state.h"

#include <Eigen/Core>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A set of effects as it was fitted.
struct KeptFit {
  std::vector<double> rough;            ///< values by some of the segments; empty: no fit of it was valid
  std::vector<double> values;           ///< by all; empty: not fitted to all
  std::vector<Eigen::VectorXd> states;  ///< with `values`: by segment its start, empty where that is not refitted
};

/// By "name @ where + name @ where" of the set.
using KeptFits = std::map<std::string, KeptFit>;

/// Where a search for what is missing stands: what a later call need not fit again.
struct UnfinishedSearch {
  KeptFits fits;                           ///< by horizon
  std::optional<SearchState> likelihoods;  ///< of the search by likelihood, where that was begun
};

}  // namespace lacuna
