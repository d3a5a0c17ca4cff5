#pragma once

#include "config/schema/experiment.h"
#include "measurement/recording.h"

#include <filesystem>
#include <optional>

namespace lacuna {

/// That another experiment file of the same name, such as the one that this was copied from, has written into the same
/// database, so that the revisions of both stand there as those of one experiment. Nothing where there is no such file
/// any more, or it has another name by now.
std::optional<ReadingNote> shared_database_note(const Experiment& experiment, const std::filesystem::path& database,
                                                const Stop& stop);

}  // namespace lacuna
