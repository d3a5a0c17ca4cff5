#pragma once

#include "foundation/processes/stop.h"

#include <cstdint>
#include <filesystem>
#include <functional>

namespace lacuna {

/// Writes what a database holds at one moment into a new file, by SQLite's online backup under one read transaction: a
/// run may go on writing meanwhile and waits for nothing. The copy has its name only when it is complete, on the disk
/// and checked page by page, and what runs ended with is held against its hashes (seal.h), so there is a sound backup
/// or none. Of a file of an older version the copy is brought up to date. `progress` gets the part that is copied, 0 to
/// 1. Returns the bytes of the new file. Throws `BadInput` where there is a file `to`, or none to copy,
/// `DamagedDatabase` where the database is damaged, `Error` where the copy cannot be written, and `Interrupted` when
/// `stop` is due.
std::uintmax_t back_up(const std::filesystem::path& database, const std::filesystem::path& to, const Stop& stop = {},
                       const std::function<void(double)>& progress = {});

/// The same for a database that its writer passes on: the copy replaces a file `to`, its reader checks the hashes, and
/// a request to stop is ignored, because it may be the reason for passing it on. A larger file `to` stays: a database
/// of results only grows, so that one is of a process that has got further.
void hand_on(const std::filesystem::path& database, const std::filesystem::path& to);

}  // namespace lacuna
