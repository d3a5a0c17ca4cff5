#pragma once

#include "foundation/processes/stop.h"

namespace lacuna {

/// From now on the first SIGINT, SIGTERM or SIGUSR1 to this process is a request to end its work (`when_interrupted`);
/// a second one ends the process at once. Signals within 0.1 s count as the first one: a signal to a process group
/// arrives from its sender and from the parent process.
void watch_for_interrupts();

/// Is due once this process got such a signal. Signals arrive at a process, so this is for the program that the process
/// runs (app/): it hands it to the work that it starts. Work that is no concern of the terminal has another `Stop`.
Stop when_interrupted();

}  // namespace lacuna
