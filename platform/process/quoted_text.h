#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lacuna {

/// What a program wrote, fit for a sentence: its first 80 characters in quotes, with a dot for each that is none of
/// ASCII's printable ones.
std::string quoted_text(std::string_view text);

/// The last lines of a text that are not blank, at most `most`, each cut to 200 characters and indented by two blanks.
std::string last_lines(std::string_view text, std::size_t most);

}  // namespace lacuna
