#pragma once

#include <filesystem>
#include <vector>

namespace lacuna {

/// Whether it is a folder as `ros2 bag record` makes them, which stands for one recording: it holds metadata.yaml.
bool is_recording_folder(const std::filesystem::path& path);

/// The files of such a folder in the order of time: those that its metadata.yaml lists under `relative_file_paths`,
/// which need not be there; else all that lie in it, by the numbers in their names.
std::vector<std::filesystem::path> files_of_recording(const std::filesystem::path& folder);

/// The path without a slash at its end, as shells complete the name of a folder.
std::filesystem::path without_last_slash(const std::filesystem::path& path);

}  // namespace lacuna
