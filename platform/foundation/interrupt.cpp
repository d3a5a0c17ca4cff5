#include "foundation/interrupt.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <thread>

namespace lacuna {
namespace {

/// When the first signal came, in ms; 0: none did. Set by a signal, read by any thread; only an atomic without a lock
/// may be both.
std::atomic<std::int64_t> requested_at = 0;
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

constexpr std::int64_t kOneWish = 100;  // ms

/// For signal handlers.
std::int64_t milliseconds_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1000 + now.tv_nsec / 1'000'000;
}

void on_signal(int signal) {
  const std::int64_t now = milliseconds_now();
  std::int64_t first = 0;
  if (requested_at.compare_exchange_strong(first, now) || now - first <= kOneWish) return;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void watch_for_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

bool interrupt_requested() { return requested_at != 0; }

void throw_if_interrupted() {
  if (interrupt_requested()) throw Interrupted("interrupted; what was finished, if anything, is kept");
}

void pause_for(double seconds) {
  constexpr double kLook = 0.05;  // s
  for (double left = seconds; left > 0.0; left -= kLook) {
    throw_if_interrupted();
    std::this_thread::sleep_for(std::chrono::duration<double>(std::min(left, kLook)));
  }
}

}  // namespace lacuna
