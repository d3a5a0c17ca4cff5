#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace lacuna {

/// Where a command's results go besides the terminal. `to`: the option's value, "" for standard
/// output. A file gets the whole text or stays as it is; `Error` then says why.
void write_output(const std::string& to, const std::string& text);

/// Whether an optional output option takes standard output, so that nothing else is printed there.
bool takes_standard_output(const std::optional<std::string>& option);

/// Called before work that takes long: throws `BadInput` where the file of an output option could not
/// be written at its end, or where both options name one file or standard output.
void check_output(const std::optional<std::string>& option, const std::optional<std::string>& other = std::nullopt);

/// The same for a folder, which is made where it is missing; an empty path is no folder.
void make_output_folder(const std::filesystem::path& folder);

}  // namespace lacuna
