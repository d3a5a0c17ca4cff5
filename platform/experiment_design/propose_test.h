#pragma once

#include "config/schema/experiment.h"
#include "experiment_design/next_test.h"
#include "experiment_design/test_conditions.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A model that may be right, fitted.
struct FittedRival {
  std::string name;
  const ModelDefinition& definition;
  std::vector<double> values;    ///< of its free values, SI
  std::optional<double> timing;  ///< of commands, in their intervals; nothing: it was not fitted
  Eigen::MatrixXd covariance;    ///< of the values' coordinates, the timing's last
};

/// How the test begins and is read, given the s between its readings.
using ConditionsAt = std::function<TestConditions(double period)>;

/// METHOD step 12, for a diagnosis that leaves two models: the test that would settle it, no longer than the longest
/// trial, within the commands of these, under the conditions that a callback gives, in one of the setups of the
/// experiment's recordings. Nothing where the robot has no actuator that takes a test.
std::optional<NextTest> propose_test(const PluginCatalog& catalog, const Experiment& experiment, const FittedRival& one,
                                     const FittedRival& other, const std::vector<Trial>& trials,
                                     const ConditionsAt& conditions_at, std::uint64_t seed, int threads);

}  // namespace lacuna
