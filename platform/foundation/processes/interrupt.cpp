#include "foundation/processes/interrupt.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <limits>
#include <thread>

namespace lacuna {
namespace {

constexpr const char* kKept = "; what was finished, if anything, is kept";

/// Time of the first signal, in ms; 0: none. Set by a signal handler, read by any thread, so it must be a lock-free
/// atomic.
std::atomic<std::int64_t> requested_at = 0;
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

constexpr std::int64_t kOneWish = 100;       // ms
constexpr std::int64_t kLongestWait = 1200;  // ms
constexpr double kLongestLimit = 1e12;       // s; its sum with a clock stays in range

constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

/// When the time is up; any thread may read it.
struct TimeLimit {
  std::atomic<std::int64_t> deadline = kNever;  // ms
  std::atomic<bool> reached = false;
  MillisecondClock clock = milliseconds_now;
  std::string typed;
} limit;

bool time_is_up() {
  const std::int64_t deadline = limit.deadline.load(std::memory_order_relaxed);
  if (deadline == kNever || limit.clock() < deadline) return false;
  limit.reached = true;
  return true;
}

void on_signal(int signal) {
  const std::int64_t now = milliseconds_now();
  std::int64_t first = 0;
  if (requested_at.compare_exchange_strong(first, now) || now - first <= kOneWish) return;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

/// Called by signal handlers.
std::int64_t milliseconds_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1000 + now.tv_nsec / 1'000'000;
}

void watch_for_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  std::signal(SIGUSR1, on_signal);  // from a batch system shortly before its time limit
}

bool interrupt_requested() { return requested_at != 0 || time_is_up(); }

void throw_if_asked_to_stop() {
  if (requested_at != 0) throw Interrupted(std::string("interrupted") + kKept);
}

void throw_if_kept_waiting() {
  const std::int64_t asked = requested_at.load(std::memory_order_relaxed);
  if (asked != 0 && milliseconds_now() - asked > kLongestWait) throw_if_asked_to_stop();
}

void throw_if_interrupted() {
  throw_if_asked_to_stop();
  if (time_is_up()) throw TimeIsUp(stopped_by_time_limit() + kKept);
}

void begin_time_limit(double seconds, const std::string& typed, MillisecondClock clock) {
  limit.clock = clock;
  limit.typed = typed;
  limit.reached = false;
  limit.deadline = clock() + static_cast<std::int64_t>(std::min(seconds, kLongestLimit) * 1e3);
}

void lift_time_limit() { limit.deadline = kNever; }

bool time_limit_was_reached() { return limit.reached; }

std::string stopped_by_time_limit() { return "stopped by --time-limit " + limit.typed; }

void pause_for(double seconds) {
  constexpr double kLook = 0.05;  // s
  for (double left = seconds; left > 0.0; left -= kLook) {
    throw_if_interrupted();
    std::this_thread::sleep_for(std::chrono::duration<double>(std::min(left, kLook)));
  }
}

}  // namespace lacuna
