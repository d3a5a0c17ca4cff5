#pragma once

#include "app/runs/open_eea_run.h"

#include <cstdint>
#include <filesystem>

namespace lacuna {

/// Integration steps of a run's models.
struct RunSteps {
  std::uint64_t taken = 0;
  std::uint64_t without_survivors = 0;  ///< were no evaluation abandoned and none reused
  std::uint64_t naive = 0;              ///< were survivors evaluated in each generation too
};

/// One replicate of an experiment, run again and again. Times are in s, by the wall clock.
class TimedRun {
 public:
  TimedRun(const std::filesystem::path& experiment, int passes);
  ~TimedRun();
  TimedRun(const TimedRun&) = delete;
  TimedRun& operator=(const TimedRun&) = delete;

  /// With every row in a database.
  double stored(int threads) const;
  /// The same run, with no row kept.
  double unstored(int threads) const;
  /// Two processes at once, each `stored(1)`: until both are done.
  double two_processes() const;
  RunSteps steps() const;

 private:
  OpenEeaRun opened_;
  std::filesystem::path folder_;
};

}  // namespace lacuna
