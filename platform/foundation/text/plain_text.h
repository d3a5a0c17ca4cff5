#pragma once

#include <string>
#include <string_view>

namespace lacuna {

/// Text from outside (file names, columns, contents of a database) for a figure or a comment: one line of well-formed
/// UTF-8. Control characters become spaces; invalid bytes become U+FFFD.
std::string plain_text(std::string_view text);

}  // namespace lacuna
