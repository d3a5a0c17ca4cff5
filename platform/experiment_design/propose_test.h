#pragma once

#include "config/schema/experiment.h"
#include "experiment_design/next_test.h"
#include "experiment_design/test_conditions.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// A fitted candidate.
struct FittedCandidate {
  std::string name;
  const ModelDefinition& definition;
  std::vector<double> values;    ///< of its free values, SI
  std::optional<double> timing;  ///< timestamp offset of the commands in command intervals; nothing: it was not fitted
  Eigen::MatrixXd covariance;    ///< of the values' coordinates, the timestamp offset last
};

/// How the test begins and is read, given the interval between its readings, s.
using ConditionsAt = std::function<TestConditions(double period)>;

/// METHOD step 12, for a diagnosis that leaves two candidates: the test that would tell them apart. It is no longer
/// than the longest trial, stays within the commands of the trials, has the conditions that a callback returns, and
/// uses one of the setups of the experiment's recordings. Nothing where the robot has no actuator that a test can
/// drive.
std::optional<NextTest> propose_test(const PluginCatalog& catalog, const Experiment& experiment,
                                     const FittedCandidate& one, const FittedCandidate& other,
                                     const std::vector<Trial>& trials, const ConditionsAt& conditions_at,
                                     std::uint64_t seed, const Work& work);

}  // namespace lacuna
