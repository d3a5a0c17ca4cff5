#include <lacuna/error.h>
#include <lacuna/plugin.h>
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

std::string Simulated::summary() const { return "A simulated robot with hidden values; takes any test"; }

Trial Simulated::carry_out(const Test& test, const TargetServices& services) {
  if (services.simulator == nullptr) throw Error("the simulated target has no robot; give it one under [target]");
  return services.simulator->simulate(test);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::TargetSystem, lacuna::Simulated>("simulated"))
