#pragma once

#include "app/workspace/open_experiment.h"
#include "measurement/recording.h"

#include <optional>

namespace lacuna {

/// Readings of recorded trials that are a simple factor too large or too small for the known forces
/// (data_checks/reading_scale.h), at the place of their column and with the line to type. Nothing where the
/// recordings say nothing of it, or the trials do not suit the model.
std::optional<ReadingNote> scale_note(const OpenExperiment& opened);

/// The line to type under [target.sensors] for such readings, as in `angle = { ..., counts_per_turn = 1024 }`; empty:
/// none.
std::string scale_correction(const OpenExperiment& opened);

/// What to write into a column's table so that its channel is divided by `factor`: `counts_per_turn = 1024`,
/// `unit = "deg"`, `gain = 4`.
std::string corrected_key(const ColumnMapping& mapping, double factor);

}  // namespace lacuna
