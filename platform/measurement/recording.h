#pragma once

#include <lacuna/target_system.h>
#include <lacuna/time_series.h>

#include "foundation/recording_source.h"

#include <string>
#include <vector>

namespace lacuna {

/// What was noticed while reading that is not an error: a documented correct reading, or a doubt.
struct ReadingNote {
  SourceLocation location;
  std::string message;
};

struct Recording {
  std::vector<Trial> trials;  ///< fit trials first, each in file order
  std::vector<ReadingNote> notes;
};

/// Reads the files of a recorded target into trials. `channels` and `actuators` are those of the
/// model's robot with their SI units; mappings to anything else are problems. Throws `BadInput`
/// with every problem of every file.
Recording read_recording(const RecordingSource& source, const std::vector<Channel>& channels,
                         const std::vector<Channel>& actuators);

}  // namespace lacuna
