#pragma once

#include "config/experiment_reader.h"
#include "evaluation/model/model_definition.h"
#include "plugins/built_catalog.h"
#include "support/simulation_run.h"
#include "support/test_folder.h"

#include <functional>
#include <string>
#include <vector>

namespace lacuna {

/// The names of all effects that are found.
std::vector<std::string> every_effect();

/// Calls `check` for every effect of the build, its name in the trace. The environment variable
/// LACUNA_EFFECTS_UNDER_TEST may name folders of other effects, with colons between them, each with its README.md; the
/// checks then run on these, which LACUNA_PLUGIN_PATH lets the program find.
void on_every_effect(const std::function<void(const std::string& name, const PhysicalEffect& effect)>& check);

/// The model of an effect's README: a robot with the effect placed on it, at values that show it.
ModelDefinition readme_model(const std::string& effect);

/// That model in motion: a servo pendulum or a wrist is driven by torques that change every 50 ms, a quadruped falls
/// onto its feet and slides. Sensors have no noise; they read in steps only where the effect makes them.
SimulationRun moving(const ModelDefinition& definition);

/// The same motion without the effect.
SimulationRun moving_without(const ModelDefinition& definition);

/// The same motion with other values of the effect's parameters.
SimulationRun moving_with(const ModelDefinition& definition, const std::vector<double>& values);

/// All readings at 40 moments of 0.8 s.
TimeSeries::Samples readings(const SimulationRun& run);

}  // namespace lacuna
