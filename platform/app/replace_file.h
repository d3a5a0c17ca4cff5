#pragma once

#include <filesystem>
#include <string>

namespace lacuna {

std::string read_text(const std::filesystem::path& file);

/// Called before work that ends with `replace_text`: throws `BadInput` where the file or its folder may not be written.
void check_replaceable(const std::filesystem::path& file);

/// Gives a user's file a new content at once: readers see the old text or the new one, also after
/// a power cut. Permissions stay; a symbolic link goes on pointing to its file. Throws `Error` where
/// the file is no longer `expected` (someone edited it meanwhile) or cannot be written; it is then
/// as it was.
void replace_text(const std::filesystem::path& file, const std::string& expected, const std::string& text);

}  // namespace lacuna
