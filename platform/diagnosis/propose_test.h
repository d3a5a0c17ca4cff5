#pragma once

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
/// trial and within the commands of the trials. Nothing where the robot has no actuator that takes a test or no test
/// tells the two apart better than a random one does.
std::optional<NextTest> propose_test(const PluginCatalog& catalog, const FittedRival& one, const FittedRival& other,
                                     const BaseSolution& base, std::uint64_t seed, int threads,
                                     const ProgressCallback& progress);

}  // namespace lacuna
