#pragma once

#include "foundation/plugins/plugin_call.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <unordered_map>

namespace lacuna {

/// How long threads of another process have been at the same thing: found out by looking now and then.
class BusyClocks {
 public:
  using Clock = std::chrono::steady_clock;

  /// For how long the thread has shown this count, s.
  double seconds(const CallSlot& slot, std::uint32_t count, Clock::time_point now);
  /// Threads that were not asked about since the last time are forgotten.
  void end_look();
  void restart() { looks_.clear(); }

 private:
  struct Look {
    std::uint32_t count = 0;
    Clock::time_point since;
    bool is_new = true;  ///< of the look under way
  };
  std::unordered_map<const CallSlot*, Look> looks_;
};

/// How long each thread has been in the same evaluation without beginning or ending another one.
class EvaluationClocks {
 public:
  /// An evaluation that takes longer than `limit` s.
  const CallSlot* overdue(double limit);
  /// Time in which nothing could be evaluated does not count.
  void restart() { clocks_.restart(); }

 private:
  BusyClocks clocks_;
};

/// A call that takes longer than it may.
struct SlowCall {
  ActiveCall call;
  double limit = 0.0;  ///< s
};

/// How long each thread has been in the same call of a plugin, outside of evaluations.
class CallClocks {
 public:
  /// What takes longer than 10 s and only tells what a component is or changes a few numbers; else longer than an
  /// evaluation may, 10 s at least; what it was allowed besides (`CallAllowance`) added.
  std::optional<SlowCall> overdue();
  void restart() { clocks_.restart(); }

 private:
  BusyClocks clocks_;
};

}  // namespace lacuna
