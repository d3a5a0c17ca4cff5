#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lacuna {

/// Whether the bytes are well-formed UTF-8 (overlong forms and surrogates are not looked for).
bool is_utf8(std::string_view text);

/// The order of the two bytes of UTF-16.
enum class Utf16 { little_endian, big_endian };

/// The byte order of UTF-16: from the byte-order mark, else from the zeros of its Latin letters. Nothing: the text is
/// not UTF-16.
std::optional<Utf16> utf16_in(std::string_view bytes);

/// Without the byte-order mark; invalid characters become U+FFFD.
std::string utf8_from_utf16(std::string_view bytes, Utf16 order);

/// Text of old Windows and instrument programs, one byte per character.
std::string utf8_from_latin1(std::string_view text);

}  // namespace lacuna
