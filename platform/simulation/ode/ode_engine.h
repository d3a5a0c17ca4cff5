#pragma once

#include "simulation/compiled_model.h"

namespace lacuna::ode {

/// Compiles a structure for ODE 0.16 in maximal coordinates. Throws `Error` as `lacuna::compile` does.
std::unique_ptr<CompiledModel> compile(ModelStructure structure, const EngineSettings& settings);

}  // namespace lacuna::ode
