#pragma once

#include "config/schema/experiment.h"
#include "evaluation/model/model_definition.h"
#include "process/process_target.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace lacuna {

/// Where notes about a target go, a sentence each; none: nowhere.
using TargetNotes = std::function<void(const std::string&)>;

/// The program that an experiment's target is, to be held against its model; null for a target of another kind. It is
/// not started yet. Trials are as reproducible as `noise_seed` and their numbers, where the program takes the seeds
/// that it is given. `stop` ends waits for the program.
std::unique_ptr<ProcessTarget> outside_target(const Experiment& experiment, const ModelDefinition& model,
                                              std::uint64_t noise_seed, const Stop& stop, TargetNotes notes = {});

/// What a target says of itself, a line: `process "pendulum": accepts whole command series (series); sensor angle in
/// rad; actuator motor, -0.6 to 0.6 N·m`.
std::string target_summary(const Hello& hello);

}  // namespace lacuna
