#pragma once

#include <string>

namespace lacuna {

/// The text with a "-" for whatever may trouble a shell or a file system.
std::string file_name(const std::string& text);

}  // namespace lacuna
