#pragma once

#include "where_it_fails/where_it_fails.h"

#include <vector>

namespace lacuna {

/// A residual and its covariates. Everything that it refers to must live during the call.
struct SelectionTask {
  const Eigen::VectorXd& residual;  ///< rows of the table; NaN where nothing is scored
  /// Covariates that explain the residual first; none: each feature is tested alone.
  const Eigen::MatrixXd& covariates;
  const FeatureTable& table;
  std::size_t family = 1;                 ///< number of tests that share the 1 % of false alarms
  std::vector<std::size_t> unasked = {};  ///< features that are not tested
  Work work = {};
};

/// Whether a test lies outside its 99 % band, corrected for the family of tests.
bool outside_band(const IndependenceTest& test, std::size_t family);

/// Fills in `mean`, `features`, `selected` and `not_on`. Features are taken one by one, the one that explains most
/// first, while each lies outside its band given those before it. With covariates two more rounds follow: one beside
/// all terms in which another mass, damping or stiffness would be linear, because fitted values partly compensate for a
/// missing effect and hide it; and one without the covariates, for the part for which fitted values compensated.
void select_features(const SelectionTask& task, ChannelTests& tests);

}  // namespace lacuna
