#pragma once

#include "config/schema/experiment.h"
#include "config/schema/table.h"

namespace lacuna {

/// The keys of each section of an experiment file, each declared once.
Table<TargetSection> target_keys();
Table<RecordingSource> recording_keys();  ///< of a recorded target
Table<ProcessSource> process_keys();      ///< of a target that is a program
Table<ModelSection> model_keys();
Table<EffectEntry> effect_keys();        ///< of a simulated target
Table<EffectEntry> model_effect_keys();  ///< the same, and what a model alone may say
/// Keys that a model and a simulated target have in common; `whose` is "model" or "target".
Table<ModelSection> system_keys(const std::string& whose);
Table<TestSection> test_keys();
Table<EstimationSection> estimation_keys();
Table<ExplorationSection> exploration_keys();
Table<EngineSettings> engine_keys();
Table<FitSection> fit_keys();
Table<NoiseSection> noise_keys();
/// The whole file.
Table<Experiment> experiment_keys();

}  // namespace lacuna
