#pragma once

#include <string>

namespace lacuna {

/// A word of a command for a POSIX shell: in quotes where needed, and on one line. For commands that are printed for
/// typing or pasting.
std::string shell_word(const std::string& word);

}  // namespace lacuna
