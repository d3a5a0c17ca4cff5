#pragma once

#include "measurement/csv/csv_table.h"
#include "measurement/csv/read_table.h"
#include "measurement/trials/recording_formats.h"
#include "measurement/trials/trial_builder.h"

#include <cstddef>
#include <vector>

namespace lacuna {

/// The files of one recording as one table.
struct ReadRecording {
  FileReport report;  ///< of the first file
  CsvTable table;     ///< invalid where there are problems
  std::vector<FileReport> further;

  bool has_problems() const;
};

/// Columns of the plan in the order of a table's: sensors, commands, references, then switches.
std::vector<const PlannedColumn*> columns_of(const RecordingPlan& plan);

/// Row numbers of each trial in a table.
std::vector<std::vector<std::size_t>> rows_by_trial(const CsvTable& table);

/// Reads the recordings of a source, in CSV or one of the other `formats`, and decodes them (decode_tables.h). Files of
/// one recording become one table on the first one's clock (join_tables.h).
std::vector<ReadRecording> read_tables(const RecordingSource& source, const RecordingPlan& plan,
                                       const RecordingFormats* formats);

}  // namespace lacuna
