#pragma once

#include <lacuna/target_system.h>

namespace lacuna {

/// A target that was measured before: its trials come from files and no test can be carried out on it.
class Recorded : public TargetSystem {
 public:
  std::string summary() const override;
  bool takes_tests() const override { return false; }
  /// What the host's `TrialReader` reads. Throws `Error` where there is none.
  std::vector<Trial> recorded(const TargetServices& services) const override;
  /// Always throws `Error`.
  Trial carry_out(const Test& test, const TargetServices& services) override;
};

}  // namespace lacuna
