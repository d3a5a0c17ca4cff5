#include "foundation/interrupt.h"

#include <csignal>

namespace lacuna {
namespace {

volatile std::sig_atomic_t requested = 0;

void on_signal(int signal) {
  if (requested != 0) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  requested = 1;
}

}  // namespace

void watch_for_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

bool interrupt_requested() { return requested != 0; }

void throw_if_interrupted() {
  if (interrupt_requested()) throw Interrupted("interrupted; what was finished is kept");
}

}  // namespace lacuna
