#pragma once

#include "where_it_fails/where_it_fails.h"

#include <vector>

namespace lacuna {

/// A residual and what it is tested against. Everything referred to must live during the call.
struct SelectionTask {
  const Eigen::VectorXd& residual;    ///< rows of the table; NaN where nothing is scored
  const Eigen::MatrixXd& covariates;  ///< what explains it first; none: each feature is tested alone
  const FeatureTable& table;
  std::size_t family = 1;                 ///< tests that share the 1 % of false alarms
  std::vector<std::size_t> unasked = {};  ///< features that are not tested
  int threads = 1;
};

/// Whether a test lies outside of its 99 % band, all tests of a family allowed for.
bool outside_band(const IndependenceTest& test, std::size_t family);

/// Fills in `mean`, `features`, `selected` and `not_on`. Features are taken one by one, the one that explains most
/// first, while each lies outside of its band after those before it. With covariates two more rounds follow: one beside
/// all that another mass, damping or stiffness would be linear in, since fitted values make up for what is missing as
/// far as they can and hide it; and one without, for what they made up.
void select_features(const SelectionTask& task, ChannelTests& tests);

}  // namespace lacuna
