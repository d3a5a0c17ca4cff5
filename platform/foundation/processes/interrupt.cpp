#include "foundation/processes/interrupt.h"

#include <csignal>

namespace lacuna {
namespace {

constexpr std::int64_t kOneWish = 100;  // ms

constinit StopRequest request_of_signals;

void on_signal(int signal) {
  const std::int64_t now = milliseconds_now();
  if (now - request_of_signals.make(now) <= kOneWish) return;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void watch_for_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  std::signal(SIGUSR1, on_signal);  // from a batch system shortly before its time limit
}

Stop when_interrupted() { return Stop(request_of_signals); }

}  // namespace lacuna
