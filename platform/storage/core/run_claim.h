#pragma once

#include "storage/core/database.h"
#include "storage/core/records.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lacuna {

/// How often a process that carries runs out shows that it lives, s (`beat_claims`), and how long one waits for a sign
/// of another.
inline constexpr double kBetweenBeats = 5.0;
inline constexpr double kSilence = 3.0 * kBetweenBeats;

/// A claim that a process of another machine has, or had.
struct ForeignClaim {
  RunId run;
  std::string holder;
  std::int64_t beat = 0;  ///< grows while the process lives
  bool operator==(const ForeignClaim&) const = default;
};

/// Those on runs of this file; a copy of a database has none.
std::vector<ForeignClaim> foreign_claims(const Database& database);

/// While it lives, no other process carries the run out. On one machine the kernel gives a claim up with the process
/// that has it, however that ends: it is a socket's name in Linux's abstract namespace, made of the database file's
/// identity and the run's number. (A lock on the database file itself would drop SQLite's own when it is closed.)
/// Between machines, and between containers with networks of their own, a row of the database says who has it.
class RunClaim {
 public:
  /// `silent`: claims whose beat has stood still for `kSilence`, which count no more. Waits for nothing.
  RunClaim(Database& database, RunId run, const std::vector<ForeignClaim>& silent = {});
  ~RunClaim();
  RunClaim(RunClaim&& other) noexcept;
  RunClaim& operator=(RunClaim&&) = delete;

  /// False: another process has it.
  bool held() const { return held_; }

 private:
  Database* database_;
  RunId run_;
  int socket_ = -1;
  bool held_ = false;
};

/// Shows others that this process lives, on all of its claims.
void beat_claims(Database& database);

/// Throws `Error` where another process has taken the run over, inside the transaction that would write it.
void check_claim(const Database& database, RunId run);

}  // namespace lacuna
