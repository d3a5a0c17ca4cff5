#include "foundation/processes/stop.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>
#include <thread>
#include <utility>

namespace lacuna {
namespace {

constexpr const char* kKept = "; what was finished, if anything, is kept";

constexpr std::int64_t kLongestWait = 1200;  // ms
constexpr double kLongestLimit = 1e12;       // s; its sum with a clock stays in range

constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

}  // namespace

/// Called by signal handlers.
std::int64_t milliseconds_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1000 + now.tv_nsec / 1'000'000;
}

std::int64_t StopRequest::make(std::int64_t now) noexcept {
  std::int64_t first = 0;
  return at_.compare_exchange_strong(first, now) ? now : first;
}

TimeLimit::TimeLimit(double seconds, std::string typed, MillisecondClock clock)
    : clock_(clock),
      typed_(std::move(typed)),
      deadline_(clock() + static_cast<std::int64_t>(std::min(seconds, kLongestLimit) * 1e3)) {}

bool TimeLimit::is_over() const {
  const std::int64_t deadline = deadline_.load(std::memory_order_relaxed);
  if (deadline == kNever || clock_() < deadline) return false;
  reached_ = true;
  return true;
}

void TimeLimit::lift() { deadline_ = kNever; }

void Stop::throw_if_requested() const {
  if (is_requested()) throw Interrupted(std::string("interrupted") + kKept);
}

void Stop::throw_if_requested_long_ago() const {
  if (milliseconds_now() - request_->made_at() > kLongestWait) throw_if_requested();
}

void Stop::throw_reason() const {
  throw_if_requested();
  throw TimeIsUp(reason_of_limit() + kKept);
}

void Stop::pause_for(double seconds) const {
  constexpr double kLook = 0.05;  // s
  for (double left = seconds; left > 0.0; left -= kLook) {
    throw_if_due();
    std::this_thread::sleep_for(std::chrono::duration<double>(std::min(left, kLook)));
  }
}

void Stop::lift_limit() const {
  if (limit_ != nullptr) limit_->lift();
}

}  // namespace lacuna
