#include "report/pages/processor_share.h"

#include <algorithm>

namespace lacuna {

void ProcessorShare::spend(double seconds, Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  pay(now);
  debt_ += seconds;
}

bool ProcessorShare::is_paid_off(Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  pay(now);
  return debt_ <= 0.0;
}

void ProcessorShare::pay(Clock::time_point now) {
  debt_ = std::max(0.0, debt_ - share_ * std::chrono::duration<double>(now - paid_until_).count());
  paid_until_ = now;
}

}  // namespace lacuna
