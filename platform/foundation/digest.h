#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lacuna {

/// SHA-256 as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);
/// The same of a file's content. Throws `Error` if it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace lacuna
