#pragma once

#include "app/runs/run_lines.h"
#include "app/terminal/progress_line.h"
#include "app/terminal/recent_rate.h"

#include <chrono>
#include <mutex>
#include <vector>

namespace lacuna {

/// Tells how far the replicates of a run are: people by one live line on a terminal, otherwise by a line a pass and,
/// as often as `pacer` allows, what the live line would show, all on standard error; machines by JSON Lines. Any
/// thread.
class RunDisplay {
 public:
  /// `lines` must live as long; may be null.
  RunDisplay(const std::vector<PlannedReplicate>& replicates, bool quiet, RunLines* lines,
             LinePacer& pacer = progress_pacer());
  ~RunDisplay();
  RunDisplay(const RunDisplay&) = delete;
  RunDisplay& operator=(const RunDisplay&) = delete;

  /// `replicate`: its place among those that are run.
  void show(std::size_t replicate, const EeaProgress& progress);
  void end_trial(std::size_t replicate, const TargetTrialRow& trial);
  void end_pass(std::size_t replicate, const PassRow& pass);
  /// A sentence that the user should see now.
  void note(std::size_t replicate, const std::string& note);
  void end_replicate(std::size_t replicate, const ReplicateEnd& end);

 private:
  using Clock = std::chrono::steady_clock;

  struct Replicate {
    PlannedReplicate planned;
    double begun_at = 0.0;  ///< share of its work that was done when it began or went on
    double done = 0.0;      ///< share of its work
    bool known = false;
    std::uint64_t evaluations = 0;  ///< since it began or went on
    std::uint64_t in_pass = 0;      ///< of the pass under way, as last told
    bool counting = false;          ///< `in_pass` was told
    std::uint64_t invalid = 0, invalid_in_pass = 0;
    Clock::time_point last_line{};
  };

  /// All replicates together.
  struct Standing {
    double rate = 0.0;        ///< evaluations per second
    double left = kNotKnown;  ///< s
    std::uint64_t invalid = 0;
  };

  void take(Replicate& own, const EeaProgress& progress);
  Standing standing() const;
  std::string line_of(const Replicate& own, const EeaProgress& progress) const;
  double seconds() const;

  std::string whose(const Replicate& own) const;

  bool live_, lines_of_text_;
  RunLines* lines_;
  LinePacer& pacer_;
  std::mutex telling_;
  std::vector<Replicate> replicates_;
  RecentRate rate_;  ///< of all replicates' evaluations
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_print_{};
};

}  // namespace lacuna
