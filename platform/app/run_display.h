#pragma once

#include "eea/eea_run.h"

#include <chrono>
#include <mutex>
#include <vector>

namespace lacuna {

/// Tells people how far the replicates of a run are: one live line on a terminal, otherwise a line a pass, both on
/// standard error. Any thread.
class RunDisplay {
 public:
  RunDisplay(int replicates, bool quiet);
  ~RunDisplay();
  RunDisplay(const RunDisplay&) = delete;
  RunDisplay& operator=(const RunDisplay&) = delete;

  void show(int replicate, const EeaProgress& progress);
  void end_pass(int replicate, const PassRow& pass);
  void end_replicate(int replicate);

 private:
  struct Replicate {
    double begun_at = 0.0;  ///< share of its work that was done when it began or went on
    double done = 0.0;      ///< share of its work
    bool known = false;
    std::uint64_t evaluations = 0;  ///< of passes that ended, since it began or went on
    std::uint64_t in_pass = 0, in_pass_before = 0;
    std::uint64_t invalid = 0, invalid_in_pass = 0;
  };

  void print(int replicate, const EeaProgress& progress);
  double seconds() const;

  bool live_, lines_;
  std::mutex printing_;
  std::vector<Replicate> replicates_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace lacuna
