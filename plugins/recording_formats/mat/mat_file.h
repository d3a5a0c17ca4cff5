#pragma once

#include <lacuna/recording_format.h>

namespace lacuna::mat {

/// The contents of a MAT file: the arrays, also those in structures, with as many rows as its time has, or as most
/// have.
RecordingContents contents_of(const std::string& path);

ReadRows rows_of(const std::string& path, const std::vector<TableQuery>& queries);

}  // namespace lacuna::mat
