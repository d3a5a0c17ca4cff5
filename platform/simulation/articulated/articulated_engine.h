#pragma once

#include "simulation/compiled_model.h"

namespace lacuna::articulated {

/// Why this engine cannot simulate the robot, a sentence; empty: it can.
std::string unsuited(const RobotSpec& robot);

/// Compiles a structure for reduced coordinates: trees of joints and floating bodies without contacts, integrated to
/// second order. Throws `Error` as `lacuna::compile` does.
std::unique_ptr<CompiledModel> compile(ModelStructure structure, const EngineSettings& settings);

}  // namespace lacuna::articulated
