#pragma once

#include <lacuna/recording_format.h>

namespace lacuna::rosbag2 {

/// The topics of a bag whose messages have numbers.
RecordingContents contents_of(const std::string& path);

ReadRows rows_of(const std::string& path, const std::vector<TableQuery>& queries);

}  // namespace lacuna::rosbag2
