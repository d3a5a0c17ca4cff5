#include "simulated.h"

#include <lacuna/error.h>
#include <lacuna/plugin.h>

namespace lacuna {

std::string Simulated::summary() const { return "A simulated robot with hidden values: takes any test"; }

Trial Simulated::carry_out(const Test& test, const TargetServices& services) {
  if (services.simulator == nullptr)
    throw Error("there is nothing to simulate the target with; give it a robot under [target]");
  return services.simulator->simulate(test);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::TargetSystem, lacuna::Simulated>("simulated"))
