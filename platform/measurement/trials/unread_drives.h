#pragma once

#include "foundation/recording_source.h"
#include "measurement/csv/csv_format.h"
#include "measurement/csv/file_report.h"

namespace lacuna {

/// A note where the experiment has no commands, although a file has columns that look like the drive of the rig: a
/// torque, a current, a voltage.
void note_unread_drives(const RecordingSource& source, const CsvFormat& format, FileReport& report);

}  // namespace lacuna
