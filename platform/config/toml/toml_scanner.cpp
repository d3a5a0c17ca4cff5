#include "config/toml/toml_scanner.h"

#include <algorithm>

namespace lacuna {
namespace {

bool three_quotes(std::string_view text, std::size_t at, char quote) {
  return at + 2 < text.size() && text[at] == quote && text[at + 1] == quote && text[at + 2] == quote;
}

std::size_t skip_short_string(std::string_view text, std::size_t at, char quote) {
  for (++at; at < text.size(); ++at) {
    if (text[at] == '\n') return at;
    if (text[at] == '\\' && quote == '"')
      ++at;
    else if (text[at] == quote)
      return at + 1;
  }
  return text.size();
}

std::size_t skip_long_string(std::string_view text, std::size_t at, char quote) {
  for (at += 3; at < text.size(); ++at) {
    if (text[at] == '\\' && quote == '"') {
      ++at;
    } else if (three_quotes(text, at, quote)) {
      at += 3;
      for (int extra = 0; extra < 2 && at < text.size() && text[at] == quote; ++extra) ++at;
      return at;
    }
  }
  return text.size();
}

bool continues_key(char c) { return c != ',' && c != '=' && c != '{' && c != '}' && c != '[' && c != ']' && c != '\n'; }

std::size_t next_code_point(std::string_view text, std::size_t at) {
  ++at;
  while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) ++at;
  return at;
}

}  // namespace

std::size_t skip_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  return std::min(
      three_quotes(text, at, quote) ? skip_long_string(text, at, quote) : skip_short_string(text, at, quote),
      text.size());
}

std::size_t skip_comment(std::string_view text, std::size_t at) {
  const std::size_t end = std::min(text.find('\n', at), text.size());
  return end > at && end < text.size() && text[end - 1] == '\r' ? end - 1 : end;
}

std::size_t skip_blanks(std::string_view text, std::size_t at) {
  while (at < text.size() && (text[at] == ' ' || text[at] == '\t')) ++at;
  return at;
}

std::size_t skip_space_and_comments(std::string_view text, std::size_t at) {
  while (at < text.size()) {
    if (text[at] == '#')
      at = skip_comment(text, at);
    else if (text[at] == ' ' || text[at] == '\t' || text[at] == '\r' || text[at] == '\n')
      ++at;
    else
      break;
  }
  return at;
}

std::optional<std::size_t> find_long_key(std::string_view text, std::size_t most) {
  std::size_t parts = 1;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = std::max(skip_string(text, at), at + 1);
      continue;
    }
    if (c == '#') {
      at = std::max(skip_comment(text, at), at + 1);
      continue;
    }
    if (!continues_key(c))
      parts = 1;
    else if (c == '.' && ++parts > most)
      return at;
    ++at;
  }
  return std::nullopt;
}

std::size_t offset_of(std::string_view text, int line, int column) {
  std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  for (int i = 1; i < line; ++i) {
    const std::size_t end = text.find('\n', at);
    if (end == std::string_view::npos) return text.size();
    at = end + 1;
  }
  for (int i = 1; i < column && at < text.size(); ++i) at = next_code_point(text, at);
  return at;
}

}  // namespace lacuna
