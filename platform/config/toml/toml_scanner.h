#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace lacuna {

/// Steps over the lexical elements of TOML text, for work that must keep every character.
/// Each function takes the offset of an element's first byte and returns the offset one past its
/// last; an element that does not end extends to the end of the text.

/// A string in any of TOML's four forms; `text[at]` is its first quotation mark.
std::size_t skip_string(std::string_view text, std::size_t at);
/// A comment without its line end; `text[at]` is '#'.
std::size_t skip_comment(std::string_view text, std::size_t at);
/// Blanks and tabs.
std::size_t skip_blanks(std::string_view text, std::size_t at);
/// Blanks, tabs, line ends and comments.
std::size_t skip_space_and_comments(std::string_view text, std::size_t at);

/// The offset of a key that has more than `most` dotted parts, judged generously: nothing that nests
/// deeper by its keys is missed.
std::optional<std::size_t> find_long_key(std::string_view text, std::size_t most);

/// The byte offset of a place counted in lines and columns (code points) from 1.
std::size_t offset_of(std::string_view text, int line, int column);

}  // namespace lacuna
