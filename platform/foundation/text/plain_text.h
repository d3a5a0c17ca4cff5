#pragma once

#include <string>
#include <string_view>

namespace lacuna {

/// Text from outside (file names, columns, what a database holds) as a picture or a comment may have it: one line of
/// well-formed UTF-8. Control characters become spaces; bytes that are no character become U+FFFD.
std::string plain_text(std::string_view text);

}  // namespace lacuna
