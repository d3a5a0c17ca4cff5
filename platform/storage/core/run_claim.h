#pragma once

#include "storage/core/database.h"
#include "storage/core/records.h"

namespace lacuna {

/// While it lives, no other process on this machine carries the run out. The kernel gives a claim up with the process
/// that has it, however that ends, and nothing is left in the file system: it is a socket's name in Linux's abstract
/// namespace, made of the database file's identity and the run's number. (A lock on the database file itself would
/// drop SQLite's own when it is closed.) Between machines, and between containers with networks of their own, only
/// `EeaStore::commit` notices two writers.
class RunClaim {
 public:
  RunClaim(const Database& database, RunId run);
  ~RunClaim();
  RunClaim(RunClaim&& other) noexcept;
  RunClaim& operator=(RunClaim&&) = delete;

  /// False: another process has it.
  bool held() const { return held_; }

 private:
  int socket_ = -1;
  bool held_ = false;
};

}  // namespace lacuna
