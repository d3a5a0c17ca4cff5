#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lacuna {

/// How many bytes the first character of a text in UTF-8 has (RFC 3629); 0 where the text does not begin with one.
std::size_t bytes_of_character(std::string_view text);

/// The characters of a text in UTF-8; each invalid byte becomes U+FFFD.
std::u32string code_points(std::string_view text);

}  // namespace lacuna
