#pragma once

#include <filesystem>
#include <string>

namespace lacuna {

/// `${NAME}` replaced by the environment variable's value. Throws `Error` that says which variable
/// is not set, or where a `${` has no end.
std::string replace_variables(const std::string& written);

/// The file that `written` names: variables replaced, relative paths taken from `directory`.
/// Throws `Error` where there is no such file or it is a folder, a device or the like.
std::filesystem::path resolve_existing_file(const std::string& written, const std::filesystem::path& directory);
/// The same, but a folder that is a recording (foundation/recording_folder.h) will do as well.
std::filesystem::path resolve_recording(const std::string& written, const std::filesystem::path& directory);

}  // namespace lacuna
