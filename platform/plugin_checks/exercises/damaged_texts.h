#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// Damaged copies of a file's bytes: truncated, with a part overwritten, empty, nonsense.
std::vector<std::string> damaged_texts(const std::string& whole);

/// The bytes of a file. Throws `Error` where it cannot be read.
std::string text_of_file(const std::filesystem::path& file);

}  // namespace lacuna
