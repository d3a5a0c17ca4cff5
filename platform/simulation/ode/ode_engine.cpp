#include "simulation/ode/ode_engine.h"

#include "simulation/ode/ode_motion.h"

namespace lacuna::ode {

std::unique_ptr<CompiledModel> compile(ModelStructure structure, const EngineSettings& settings) {
  return std::make_unique<simulation::EngineModel>(
      std::move(structure), settings,
      [](const simulation::EngineModel& model) { return std::make_unique<OdeMotion>(model); });
}

}  // namespace lacuna::ode
