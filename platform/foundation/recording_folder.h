#pragma once

#include <filesystem>
#include <vector>

namespace lacuna {

/// Whether the folder is one recording, as `ros2 bag record` writes it: it has a metadata.yaml.
bool is_recording_folder(const std::filesystem::path& path);

/// The files of such a folder in order of time: those that metadata.yaml lists under `relative_file_paths`, whether
/// they exist or not; if it lists none, all files of the folder, sorted by the numbers in their names.
std::vector<std::filesystem::path> files_of_recording(const std::filesystem::path& folder);

/// The path without the slash that a shell's completion appends to the name of a folder.
std::filesystem::path without_last_slash(const std::filesystem::path& path);

}  // namespace lacuna
