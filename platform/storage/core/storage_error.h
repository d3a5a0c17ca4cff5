#pragma once

#include <lacuna/error.h>

#include <filesystem>
#include <string>

struct sqlite3;
namespace SQLite {
class Exception;
}

namespace lacuna {

/// What was stored cannot be relied on any more.
class DamagedDatabase : public Error {
 public:
  using Error::Error;
};

/// Throws the `Error` whose sentence says what an error code of SQLite means for this file and
/// what to do about it.
[[noreturn]] void throw_storage_error(const std::filesystem::path& file, int extended_code, const std::string& message);
[[noreturn]] void throw_storage_error(const std::filesystem::path& file, const SQLite::Exception& error);
/// The same for a file that may not be written to.
[[noreturn]] void throw_read_only(const std::filesystem::path& file);

}  // namespace lacuna
