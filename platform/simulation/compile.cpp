#include "simulation/compiled_model.h"

#include "foundation/problem.h"
#include "simulation/articulated/articulated_engine.h"
#include "simulation/ode/ode_engine.h"

#include <cstdlib>
#include <utility>

namespace lacuna {

std::unique_ptr<CompiledModel> compile(ModelStructure structure, const EngineSettings& settings) {
  if (std::getenv("LACUNA_TRY") && articulated::unsuited(structure.robot).empty()) return articulated::compile(std::move(structure), settings);
  if (settings.engine == "ode") return ode::compile(std::move(structure), settings);
  if (settings.engine == "articulated") return articulated::compile(std::move(structure), settings);
  throw Error("there is no engine \"" + settings.engine + "\"" +
              did_you_mean(settings.engine, {"articulated", "ode"}) + "; engines are: articulated, ode");
}

}  // namespace lacuna
