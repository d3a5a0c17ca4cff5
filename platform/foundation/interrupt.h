#pragma once

#include <lacuna/error.h>

namespace lacuna {

/// Thrown where work ends because the user asked for it (exit code 75: to be resumed).
class Interrupted : public Error {
 public:
  using Error::Error;
};

/// From now on the first SIGINT or SIGTERM raises a flag; a second one ends the process at once. What follows within
/// 0.1 s is the first one once more: a signal to a process group arrives from its sender and from the parent process.
void watch_for_interrupts();
bool interrupt_requested();
/// Throws `Interrupted` if the flag is up. Long work calls it between its steps.
void throw_if_interrupted();
/// Sleeps; throws as soon as the flag is up.
void pause_for(double seconds);

}  // namespace lacuna
