#pragma once

#include <string>
#include <string_view>

namespace lacuna {

/// Whether the bytes are well-formed UTF-8 (overlong forms and surrogates are not looked for).
bool is_utf8(std::string_view text);

/// Text of old Windows and instrument programs, one byte a character.
std::string utf8_from_latin1(std::string_view text);

}  // namespace lacuna
