#pragma once

#include <filesystem>
#include <string>

namespace lacuna {

/// A line of a draft with its comment to the right of it. A column's name may be in the comment, and may have line
/// breaks in it.
std::string with_comment(const std::string& line, const std::string& comment);

/// A blank as it stands in a draft, `"FILL IN kg"` with its quotes; left as it is, `check` refuses it.
std::string blank(const std::string& unit);

/// A path as the experiment names it: from its own folder where the file is not far from it.
std::string path_in_file(const std::filesystem::path& file, const std::filesystem::path& experiment);

}  // namespace lacuna
