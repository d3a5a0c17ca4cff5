#include <lacuna/error.h>
#include <lacuna/plugin.h>
#include <lacuna/target_system.h>

namespace lacuna {

/// A target with recorded trials: they come from files, and no test can be carried out.
class Recorded : public TargetSystem {
 public:
  std::string summary() const override;
  bool takes_tests() const override { return false; }
  /// The trials of the host's `TrialReader`. Throws `Error` where there is none.
  std::vector<Trial> recorded(const TargetServices& services) const override;
  /// Always throws `Error`.
  Trial carry_out(const Test& test, const TargetServices& services) override;
};

std::string Recorded::summary() const { return "Recorded files: trials that already exist"; }

std::vector<Trial> Recorded::recorded(const TargetServices& services) const {
  if (services.trials == nullptr)
    throw Error("there are no files to read trials from; name recorded files under [target]");
  return services.trials->read();
}

Trial Recorded::carry_out(const Test&, const TargetServices&) {
  throw Error("a recorded target takes no tests; record more files, or choose a target that can be driven");
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::TargetSystem, lacuna::Recorded>("recorded"))
