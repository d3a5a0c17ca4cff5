#include <lacuna/error.h>
#include <lacuna/plugin.h>
#include <lacuna/target_system.h>

namespace lacuna {

/// A simulated robot with hidden values; any test can be carried out on it.
class Simulated : public TargetSystem {
 public:
  std::string summary() const override;
  bool takes_tests() const override { return true; }
  /// The trials of the host's `Simulator`. Throws `Error` where there is none.
  Trial carry_out(const Test& test, const TargetServices& services) override;
};

std::string Simulated::summary() const { return "A simulated robot with hidden values; takes any test"; }

Trial Simulated::carry_out(const Test& test, const TargetServices& services) {
  if (services.simulator == nullptr) throw Error("the simulated target has no robot; give it one under [target]");
  return services.simulator->simulate(test);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::TargetSystem, lacuna::Simulated>("simulated"))
