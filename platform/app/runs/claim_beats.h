#pragma once

#include "storage/core/database.h"

#include <mutex>
#include <thread>

namespace lacuna {

/// While it lives, processes on other machines see that this one carries its runs out.
class ClaimBeats {
 public:
  /// `writing`: held while the database is written. Both must outlive it.
  ClaimBeats(Database& database, std::mutex& writing);

 private:
  std::jthread beating_;
};

}  // namespace lacuna
