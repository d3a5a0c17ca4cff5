#include "foundation/interrupt.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>

namespace lacuna {
namespace {

/// Set by a signal, read by any thread; only an atomic without a lock may be both.
std::atomic<bool> requested = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void on_signal(int signal) {
  if (requested.exchange(true)) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

void watch_for_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

bool interrupt_requested() { return requested; }

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
