#pragma once

#include <lacuna/error.h>

#include <cstdint>
#include <string>

namespace lacuna {

/// Thrown where work ends because the user asked for it (exit code 75: to be resumed).
class Interrupted : public Error {
 public:
  using Error::Error;
};

/// Thrown where work ends because its time limit is reached. Who catches it lifts the limit and brings the work to an
/// end with what is known so far; elsewhere it ends the work as Ctrl-C does.
class TimeIsUp : public Interrupted {
 public:
  using Interrupted::Interrupted;
};

/// From now on the first SIGINT, SIGTERM or SIGUSR1 raises a flag; a second one ends the process at once. What follows
/// within 0.1 s is the first one once more: a signal to a process group arrives from its sender and from the parent
/// process.
void watch_for_interrupts();
/// Whether the flag is up, or the time limit is reached and not lifted.
bool interrupt_requested();
/// Throws `Interrupted` if the flag is up, `TimeIsUp` if the limit is reached and not lifted. Long work calls it
/// between its steps.
void throw_if_interrupted();
/// The same whatever the time limit: for what is short, and the rest follows from.
void throw_if_asked_to_stop();
/// The same once the user has waited for more than a second: for what is usually short, and has to come to its end to
/// be of use.
void throw_if_kept_waiting();
/// Sleeps; throws as soon as the flag is up.
void pause_for(double seconds);

/// Milliseconds of a clock that only goes forward.
using MillisecondClock = std::int64_t (*)();
std::int64_t milliseconds_now();
/// From now on `interrupt_requested` is true once `seconds` have passed; call it before there are threads. `typed`: the
/// limit in the user's words, for messages.
void begin_time_limit(double seconds, const std::string& typed, MillisecondClock clock = milliseconds_now);
/// What follows is brought to an end without a limit; Ctrl-C still ends it.
void lift_time_limit();
/// Whether the limit was reached at any time, lifted or not.
bool time_limit_was_reached();
/// "stopped by --time-limit 5 min".
std::string stopped_by_time_limit();

}  // namespace lacuna
