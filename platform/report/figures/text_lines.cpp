#include "report/figures/text_lines.h"

#include "report/figures/figure_series.h"

#include <algorithm>
#include <string_view>

namespace lacuna {
namespace {

bool begins_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

/// Pieces that end behind one of the characters.
std::vector<std::string> pieces_of(const std::string& text, std::string_view ends) {
  const auto is_end = [&](char c) { return ends.find(c) != std::string_view::npos; };
  std::vector<std::string> pieces(1);
  for (const char c : text) {
    if (!pieces.back().empty() && is_end(pieces.back().back()) && !is_end(c)) pieces.emplace_back();
    pieces.back() += c;
  }
  return pieces;
}

std::string without_end(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

/// The first so many letters; takes them off `text`.
std::string taken(std::string& text, std::size_t letters) {
  std::size_t end = 0;
  for (std::size_t count = 0; end < text.size(); ++end)
    if (begins_letter(text[end]) && ++count > letters) break;
  std::string first = text.substr(0, end);
  text.erase(0, end);
  return first;
}

std::string joined(const std::vector<std::string>& lines, std::string (*quoted_line)(const std::string&)) {
  std::string text;
  for (const std::string& line : lines) {
    const std::string one = quoted_line(line);
    text += (text.empty() ? "" : "\\n") + one.substr(1, one.size() - 2);
  }
  return '"' + text + '"';
}

/// Puts a piece behind the last line where there is room, or into a line of its own.
bool put(const std::string& piece, std::size_t letters, std::vector<std::string>& lines) {
  const bool joins = !lines.empty() && letters_of(without_end(lines.back() + piece)) <= letters;
  if (!joins && letters_of(without_end(piece)) > letters) return false;
  if (joins)
    lines.back() += piece;
  else
    lines.push_back(piece);
  return true;
}

}  // namespace

std::size_t letters_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_letter));
}

std::size_t longest_of(const std::vector<std::string>& texts) {
  std::size_t longest = 0;
  for (const std::string& text : texts) longest = std::max(longest, letters_of(text));
  return longest;
}

std::vector<std::string> lines_of(const std::string& text, std::size_t letters) {
  letters = std::max<std::size_t>(letters, 1);
  std::vector<std::string> lines;
  for (const std::string& word : pieces_of(text, " ")) {
    if (put(word, letters, lines)) continue;
    for (std::string piece : pieces_of(word, "_.*")) {
      if (put(piece, letters, lines)) continue;
      while (letters_of(without_end(piece)) > letters) lines.push_back(taken(piece, letters));
      if (!piece.empty()) lines.push_back(piece);
    }
  }
  for (std::string& line : lines) line = without_end(line);
  if (lines.empty()) lines.emplace_back();
  return lines;
}

std::string quoted_lines(const std::vector<std::string>& lines) { return joined(lines, quoted); }

std::string quoted_tick_lines(const std::vector<std::string>& lines) { return joined(lines, quoted_tick); }

}  // namespace lacuna
