#pragma once

#include <lacuna/recording_format.h>

namespace lacuna::json_lines {

/// What the first lines of a file have.
RecordingContents contents_of(const std::string& path);

/// The wanted columns of all lines.
ReadRows rows_of(const std::string& path, const std::vector<TableQuery>& queries);

}  // namespace lacuna::json_lines
