#pragma once

#include <chrono>
#include <mutex>

namespace lacuna {

/// Keeps work to a share of one processor's time: what was spent is a debt that time pays off. Several threads may ask.
class ProcessorShare {
 public:
  using Clock = std::chrono::steady_clock;

  /// `share`: between 0 and 1.
  explicit ProcessorShare(double share) : share_(share) {}

  void spend(double seconds, Clock::time_point now = Clock::now());
  /// Whether all that was spent until now was within the share.
  bool is_paid_off(Clock::time_point now = Clock::now());

 private:
  void pay(Clock::time_point now);
  const double share_;
  std::mutex mutex_;
  Clock::time_point paid_until_ = {};
  double debt_ = 0.0;  ///< s of the processor
};

}  // namespace lacuna
