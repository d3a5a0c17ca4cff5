#pragma once

#include <string>

namespace lacuna {

/// A word of a command as a POSIX shell takes it: in quotes where it needs them, and on one line. For commands that are
/// printed to be typed or pasted.
std::string shell_word(const std::string& word);

}  // namespace lacuna
