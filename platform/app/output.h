#pragma once

#include <optional>
#include <string>

namespace lacuna {

/// Where a command's results go besides the terminal. `to`: the option's value, "" for standard
/// output. Throws `Error` where the file cannot be written.
void write_output(const std::string& to, const std::string& text);

/// Whether an optional output option takes standard output, so that nothing else is printed there.
bool takes_standard_output(const std::optional<std::string>& option);

}  // namespace lacuna
