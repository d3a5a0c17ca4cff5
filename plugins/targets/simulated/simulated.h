#pragma once

#include <lacuna/target_system.h>

namespace lacuna {

/// A target that is a robot with hidden values in the simulator; any test can be carried out on it.
class Simulated : public TargetSystem {
 public:
  std::string summary() const override;
  bool takes_tests() const override { return true; }
  /// What the host's `Simulator` gives. Throws `Error` where there is none.
  Trial carry_out(const Test& test, const TargetServices& services) override;
};

}  // namespace lacuna
