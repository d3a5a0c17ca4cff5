#include "simulation/compiled_model.h"

#include "foundation/text/problem.h"
#include "simulation/articulated/articulated_engine.h"
#include "simulation/ode/ode_engine.h"

#include <utility>

namespace lacuna {

std::string engine_for(const RobotSpec& robot) { return articulated::unsuited(robot).empty() ? "articulated" : "ode"; }

std::unique_ptr<CompiledModel> compile(ModelStructure structure, const EngineSettings& asked) {
  EngineSettings settings = asked;
  if (settings.engine.empty()) settings.engine = engine_for(structure.robot);
  if (settings.substeps == 0) settings.substeps = 1;
  if (settings.engine == "ode") return ode::compile(std::move(structure), settings);
  if (settings.engine == "articulated") return articulated::compile(std::move(structure), settings);
  throw Error("there is no engine \"" + settings.engine + "\"" + did_you_mean(settings.engine, {"articulated", "ode"}) +
              "; engines are: articulated, ode");
}

}  // namespace lacuna
