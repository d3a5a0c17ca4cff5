#include "foundation/text/plain_text.h"

#include "foundation/text/code_points.h"

namespace lacuna {
namespace {

constexpr std::string_view kNoCharacter = "\xEF\xBF\xBD";  // U+FFFD

bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  return first < 0x20 || first == 0x7F || (first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0);
}

/// U+FFFE and U+FFFF, which XML refuses.
bool is_reserved(std::string_view character) { return character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF"; }

}  // namespace

std::string plain_text(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    const std::size_t count = bytes_of_character(text);
    const std::string_view character = text.substr(0, count);
    if (count == 0 || is_reserved(character))
      plain += kNoCharacter;
    else if (is_control(character))
      plain += ' ';
    else
      plain += character;
    text.remove_prefix(count == 0 ? 1 : count);
  }
  return plain;
}

}  // namespace lacuna
