#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lacuna {

/// What a program wrote, fit for a sentence: its first 80 characters in quotes, with a dot for each that is none of
/// ASCII's printable ones.
std::string quoted_text(std::string_view text);

/// A name or a sentence that a program sent, in UTF-8, fit to be printed: its first `most` bytes, cut between
/// characters, with a dot for each control character.
std::string plain_text(std::string_view text, std::size_t most = 80);

/// The last lines of a text that are not blank, at most `most`, each cut to 200 characters and indented by two blanks.
std::string last_lines(std::string_view text, std::size_t most);

}  // namespace lacuna
