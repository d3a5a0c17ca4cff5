#include "recorded.h"

#include <lacuna/error.h>
#include <lacuna/plugin.h>

namespace lacuna {

std::string Recorded::summary() const { return "Measured files: trials that exist already"; }

std::vector<Trial> Recorded::recorded(const TargetServices& services) const {
  if (services.trials == nullptr)
    throw Error("there is nothing to read trials from; name measured files under [target]");
  return services.trials->read();
}

Trial Recorded::carry_out(const Test&, const TargetServices&) {
  throw Error("a recorded target takes no tests; measure more files, or choose a target that can be driven");
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::TargetSystem, lacuna::Recorded>("recorded"))
