#pragma once

#include <lacuna/recording_format.h>

namespace lacuna::json_lines {

/// The contents of the first lines of a file.
RecordingContents contents_of(const std::string& path);

/// The requested columns of all lines.
ReadRows rows_of(const std::string& path, const std::vector<TableQuery>& queries);

}  // namespace lacuna::json_lines
