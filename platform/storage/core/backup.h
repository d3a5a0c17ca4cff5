#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

namespace lacuna {

/// Writes what a database holds at one moment into a new file, by SQLite's online backup under one read transaction: a
/// run may go on writing meanwhile and waits for nothing. The copy has its name only when it is complete, on the disk
/// and checked page by page, so there is a sound backup or none. Of a file of an older version the copy is brought up
/// to date. `progress` gets the part that is copied, 0 to 1. Returns the bytes of the new file. Throws `BadInput` where
/// there is a file `to`, or none to copy, `Error` where the database is damaged or the copy cannot be written, and
/// `Interrupted`.
std::uintmax_t back_up(const std::filesystem::path& database, const std::filesystem::path& to,
                       const std::function<void(double)>& progress = {});

}  // namespace lacuna
