#pragma once

#include <filesystem>

namespace lacuna {

/// Throws the `Error` for a file of results that could not be written to its end.
[[noreturn]] void throw_not_written(const std::filesystem::path& file);

}  // namespace lacuna
