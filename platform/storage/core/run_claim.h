#pragma once

#include "storage/core/database.h"
#include "storage/core/records.h"

#include <cstdint>
#include <functional>
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

/// Claims of other machines on these runs, once `kSilence` has passed: those whose processes live are others by then.
/// Does not wait where there are none. `before_waiting`: tells the user.
std::vector<ForeignClaim> silent_claims(const Database& database, const std::vector<RunId>& runs,
                                        const std::function<void()>& before_waiting = {});

/// While it lives, no other process carries the run out: a row of the database says who does. On one machine the row
/// counts as long as that process lives, which the kernel tells: each process that claims something has a socket's name
/// in Linux's abstract namespace. (A lock on the database file itself would drop SQLite's own when it is closed.)
/// Between machines, and between containers with networks of their own, it counts while it beats.
class RunClaim {
 public:
  /// `silent`: claims whose beat has stood still for `kSilence`, which count no more. Waits for nothing. Throws `Error`
  /// where this process cannot show that it lives.
  RunClaim(Database& database, RunId run, const std::vector<ForeignClaim>& silent = {});
  ~RunClaim();
  RunClaim(RunClaim&& other) noexcept;
  RunClaim& operator=(RunClaim&&) = delete;

  /// False: another process has it.
  bool held() const { return held_; }
  /// Ends claims of one database in one transaction, for there may be thousands.
  static void release(std::vector<RunClaim>& claims);

 private:
  void remove_row();

  Database* database_;
  RunId run_;
  bool held_ = false;
};

/// Shows others that this process lives, on all of its claims.
void beat_claims(Database& database);

/// Whether another process has taken the run over.
bool is_taken_over(const Database& database, RunId run);
/// Throws `Error` then, inside the transaction that would write it.
void check_claim(const Database& database, RunId run);

}  // namespace lacuna
