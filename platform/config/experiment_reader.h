#pragma once

#include "config/schema/experiment.h"

#include <string>
#include <vector>

namespace lacuna {

/// Reads and validates an experiment file and the robot file it names. `overrides` are `key=value`
/// with a TOML value, as from `--set`. Throws `BadInput` with every problem found: unknown keys,
/// wrong types, wrong units, bounds the wrong way round, files that do not exist.
/// Checks that need plugins (names, parameters, addresses) are in evaluation/model/model_definition.
Experiment read_experiment(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The same from text, for tests and fuzzing; `file` is used in messages and for relative paths.
Experiment read_experiment_text(const std::string& text, const std::filesystem::path& file,
                                const std::vector<std::string>& overrides = {});

}  // namespace lacuna
