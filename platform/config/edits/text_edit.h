#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// A stretch of text, from its first byte to one past its last.
struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// A stretch of a text and what stands there instead.
struct TextEdit {
  Span span;
  std::string replacement;
};

/// The text with all edits made; they must not overlap.
std::string edited(std::string_view text, std::vector<TextEdit> edits);

/// The first byte of the line around `at`; the end of that line without its line end.
std::size_t line_begin(std::string_view text, std::size_t at);
std::size_t line_end(std::string_view text, std::size_t at);
/// One past the line end that begins at `at`, if one does.
std::size_t after_line_end(std::string_view text, std::size_t at);
/// "\r\n" where the text's first line ends so, else "\n".
std::string line_end_of(std::string_view text);
/// The blanks and tabs that the line around `at` begins with.
std::string_view indentation(std::string_view text, std::size_t at);

}  // namespace lacuna
