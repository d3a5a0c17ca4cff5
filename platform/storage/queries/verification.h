#pragma once

#include "storage/integrity/seal.h"

#include <functional>
#include <string>
#include <vector>

namespace lacuna {

/// What a database has that it should not have.
struct Verification {
  SealCheck seals;
  std::vector<std::string> damage;  ///< of the file, its keys, traces and texts; a sentence each
  bool is_sound() const { return damage.empty() && seals.broken.empty(); }
};

/// Holds everything that is stored against the hashes that were stored with it: runs against their seals (seal.h),
/// traces and texts of experiments against their own, and the pages against SQLite's rules; and the schema against that
/// of this program. All of one state of the file, which the connection sees from then on. Nothing is written.
/// `progress` gets the part that is done, 0 to 1. Throws `Error` where the file is no database of this program, and
/// `Interrupted`.
Verification verify(const Database& database, const std::function<void(double)>& progress = {});

}  // namespace lacuna
