#pragma once

#include <filesystem>
#include <string>

namespace lacuna {

/// The files in which SQLite keeps what is not yet in a database (`-wal`, `-journal`) are found by their names alone:
/// one that another database left behind, whose file was moved or replaced, would be played into whatever file has the
/// name now, and destroy it. This looks at them before SQLite does, and puts one that does not belong to the file aside
/// under another name, which a line on standard error tells; nothing is deleted. One that belongs to the file, or that
/// a running process uses with it, stays. Returns an empty text or, where it cannot be put aside, a sentence that says
/// so: then the file may only be read as it is (`immutable`). The file must exist.
std::string put_foreign_log_aside(const std::filesystem::path& database);

/// Of a file that SQLite keeps beside the database: the name with `tail`, as SQLite finds it.
std::filesystem::path beside(const std::filesystem::path& database, const char* tail);

bool has_content(const std::filesystem::path& file);

/// Gives a file the name `FILE.set-aside`, or one with a number behind it; the new name. Throws
/// `std::filesystem::filesystem_error`.
std::filesystem::path set_aside(const std::filesystem::path& file);

}  // namespace lacuna
