#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// A file's bytes as they come to readers at times: broken off, with a piece overwritten, empty, nonsense.
std::vector<std::string> damaged_texts(const std::string& whole);

/// The bytes of a file. Throws `Error` where it cannot be read.
std::string text_of_file(const std::filesystem::path& file);

}  // namespace lacuna
