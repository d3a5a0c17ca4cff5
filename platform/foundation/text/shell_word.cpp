#include "foundation/text/shell_word.h"

#include <algorithm>

namespace lacuna {
namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

std::string escaped(char c) {
  constexpr const char* kDigits = "01234567";
  const auto byte = static_cast<unsigned char>(c);
  return {'\\', kDigits[byte >> 6U], kDigits[byte >> 3U & 7U], kDigits[byte & 7U]};
}

/// `$'...'`, which not all shells know (POSIX of 2024).
std::string on_one_line(const std::string& word) {
  std::string quoted = "$'";
  for (const char c : word) {
    if (is_control(c))
      quoted += escaped(c);
    else
      quoted += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return quoted + "'";
}

}  // namespace

std::string shell_word(const std::string& word) {
  constexpr const char* kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  if (std::any_of(word.begin(), word.end(), is_control)) return on_one_line(word);
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace lacuna
