#pragma once

#include <lacuna/target_system.h>

namespace lacuna {

/// A target that is another program; what it can carry out it says itself.
class Process : public TargetSystem {
 public:
  std::string summary() const override;
  bool takes_tests() const override { return true; }
  /// What the host's `ExternalProgram` gives. Throws `Error` where there is none.
  Trial carry_out(const Test& test, const TargetServices& services) override;
};

}  // namespace lacuna
