#pragma once

#include <filesystem>
#include <string>

namespace lacuna {

/// The content of a file that a user wrote, byte for byte. Throws `BadInput` with the file as
/// place where it does not exist, cannot be read or is longer than 4 MiB.
std::string read_text_file(const std::filesystem::path& file);

}  // namespace lacuna
