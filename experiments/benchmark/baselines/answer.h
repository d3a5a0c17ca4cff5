#pragma once

#include "baselines/candidate.h"

#include <ctime>
#include <string>
#include <vector>

namespace hidden_effects {

/// An effect at a place; what its score means, more being better, depends on the baseline.
struct RankedEffect {
  std::string effect;
  Place place = Place::joint;
  int element = 0;  ///< joint, body, drive or sensor; 0 of the world
  double score = 0.0;
};

/// What a baseline says of a case.
struct BaselineAnswer {
  std::string name;
  std::vector<RankedEffect> ranking;  ///< best first
  std::size_t chosen = 0;             ///< the first so many are there, it says
  double seconds = 0.0;               ///< of processor time it would have needed alone
  bool nothing_missing() const { return chosen == 0; }
};

inline RankedEffect ranked(const Candidate& candidate, double score) {
  return {candidate.law.kind->effect, candidate.law.kind->place, candidate.law.element, score};
}

/// Processor seconds of this thread since it was made.
class ProcessorTime {
 public:
  double seconds() const { return now() - begin_; }

 private:
  static double now() {
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  double begin_ = now();
};

}  // namespace hidden_effects
