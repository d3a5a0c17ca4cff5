#pragma once

#include <lacuna/recording_format.h>

namespace lacuna::numpy {

/// The contents of an .npy or .npz file: of an archive the arrays with as many rows as its time has, or as most have.
RecordingContents contents_of(const std::string& path);

ReadRows rows_of(const std::string& path, const std::vector<TableQuery>& queries);

}  // namespace lacuna::numpy
