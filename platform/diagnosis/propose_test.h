#pragma once

#include "config/experiment.h"
#include "diagnosis/next_test.h"
#include "diagnosis/round.h"

#include <optional>
#include <string>

namespace lacuna {

/// A model that may be right, fitted.
struct FittedRival {
  std::string name;
  const ModelDefinition& definition;
  const Refit& fit;
};

/// METHOD step 12, for a diagnosis that leaves two models: the test that would settle it, no longer than the longest
/// trial, begun as these were and within their commands, read with the noise of the round, in one of the setups of the
/// experiment's recordings. Nothing where the robot has
/// no actuator that takes a test.
std::optional<NextTest> propose_test(const PluginCatalog& catalog, const Experiment& experiment, const FittedRival& one,
                                     const FittedRival& other, const Round& round, std::uint64_t seed, int threads,
                                     const ProgressCallback& progress);

/// Whether a test tells enough for a trip to the rig, and more than a random one does.
bool worthwhile(const NextTest& test);

}  // namespace lacuna
