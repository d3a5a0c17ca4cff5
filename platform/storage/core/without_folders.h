#pragma once

#include <string>
#include <string_view>

namespace lacuna {

/// A text (a file's name, a command, a sentence) with the file's name alone in place of each absolute path: folders
/// tell about a machine and its users. Relative paths, and what only looks like a path, stay.
std::string without_folders(std::string_view text);

}  // namespace lacuna
