#pragma once

#include "measurement/csv/file_report.h"
#include "measurement/guesses/file_sample.h"

namespace lacuna {

/// The beginning of a file that one of the formats reads; invalid where the report has problems.
FileSample sample_recording(const std::filesystem::path& path, const RecordingFormats& formats, FileReport& report);

}  // namespace lacuna
