#pragma once

#include "measurement/csv_table.h"
#include "measurement/trial_builder.h"

#include <cstddef>
#include <vector>

namespace lacuna {

/// A measured file as numbers, and what was noticed in it.
struct ReadTable {
  FileReport report;
  CsvTable table;  ///< of no meaning where the report has problems
};

/// Row numbers of each trial in a table.
std::vector<std::vector<std::size_t>> rows_by_trial(const CsvTable& table);

/// Reads the files of a source: the columns of the plan (sensors, commands, references, switches) as the devices meant
/// them. Encodings that the source does not state are those that a column shows in all files together; each that is
/// found is noted, with the line that states it. Numbers that a device never wrote (1e-308) are missing.
std::vector<ReadTable> read_tables(const RecordingSource& source, const RecordingPlan& plan);

}  // namespace lacuna
