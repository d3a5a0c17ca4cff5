#pragma once

#include "foundation/files/whole_file.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// Where a command's results go besides the terminal. `to`: the option's value, "" for standard
/// output. A file gets the whole text or stays as it is; `Error` then says why.
void write_output(const std::string& to, const std::string& text, Existing existing = Existing::replaced);

/// Whether an optional output option takes standard output, so that nothing else is printed there.
bool takes_standard_output(const std::optional<std::string>& option);

/// Called before work that takes long: throws `BadInput` where the file of an output option could not be written at its
/// end, is one that the command reads, or is named by another output option, or where both options name standard
/// output.
void check_output(const std::optional<std::string>& option, const std::optional<std::string>& other = std::nullopt);

/// The same for one file; where `existing` is refused, `BadInput` also where there is a regular file of that name.
void check_new_output(const std::optional<std::string>& option, Existing existing);

/// Called where a command begins: those of an earlier one in this process are forgotten.
void forget_command_files();

/// Called by whoever names or opens what a command reads, before work that takes long: throws `BadInput` where an
/// output is one of them or a log that SQLite keeps beside it, by whatever name, for then the results would take its
/// place. Files that are not there yet count by their names. Outputs that are named or written later are refused
/// likewise.
void refuse_outputs_among(const std::vector<std::filesystem::path>& inputs);

/// The same as `check_output` for a folder, which may be missing; an empty path is no folder.
void check_output_folder(const std::filesystem::path& folder);

/// A picture's place in the folder. Throws `BadInput` where a folder or a file that the command reads has its name.
std::filesystem::path file_for_picture(const std::filesystem::path& folder, const std::string& name);

/// Called when there are results for it: makes it where it is missing.
void make_output_folder(const std::filesystem::path& folder);

}  // namespace lacuna
