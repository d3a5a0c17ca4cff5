#include "process.h"

#include <lacuna/error.h>
#include <lacuna/plugin.h>

namespace lacuna {

std::string Process::summary() const { return "A program of its own, such as a rig's driver or another simulator"; }

Trial Process::carry_out(const Test& test, const TargetServices& services) {
  if (services.program == nullptr)
    throw Error("there is no program to carry the test out; give it a command under [target]");
  return services.program->carry_out(test);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::TargetSystem, lacuna::Process>("process"))
