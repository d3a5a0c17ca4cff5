#pragma once

#include "measurement/trials/read_tables.h"

#include <vector>

namespace lacuna {

/// Makes one table of the files of a recording, on the first one's clock: a row for each time at which any of them has
/// one, with no value (NaN) where that file's column has none. So readings keep their own times. Unknown offsets and
/// skews are estimated (clock_alignment.h) and noted with their standard errors. The table begins and ends with the
/// first file or, if commands come from another, where all commands are known. Files without a common time are a
/// problem. Rows of further files have no line.
ReadRecording join_tables(const RecordingSource& source, const RecordingPlan& plan, const MeasuredFile& file,
                          std::vector<ReadTable> tables);

}  // namespace lacuna
