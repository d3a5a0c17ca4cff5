#pragma once

#include <lacuna/error.h>

#include <cstdint>
#include <string>

namespace lacuna {

/// Thrown where work ends because the user asked for it (exit code 75: can be resumed).
class Interrupted : public Error {
 public:
  using Error::Error;
};

/// Thrown where work ends because its time limit is reached. A handler lifts the limit and completes the work with the
/// results so far; elsewhere the work ends as after Ctrl-C.
class TimeIsUp : public Interrupted {
 public:
  using Interrupted::Interrupted;
};

/// From now on the first SIGINT, SIGTERM or SIGUSR1 raises a flag; a second one ends the process at once. Signals
/// within 0.1 s count as the first one: a signal to a process group arrives from its sender and from the parent
/// process.
void watch_for_interrupts();
/// Whether the flag is up, or the time limit is reached and not lifted.
bool interrupt_requested();
/// Throws `Interrupted` if the flag is up, `TimeIsUp` if the limit is reached and not lifted. Long work calls it
/// between its steps.
void throw_if_interrupted();
/// The same without the time limit: for short work on which the rest depends.
void throw_if_asked_to_stop();
/// The same after the user has waited for more than a second: for work that is usually short and useless if incomplete.
void throw_if_kept_waiting();
/// Sleeps; throws as soon as the flag is up.
void pause_for(double seconds);

/// Milliseconds of a monotonic clock.
using MillisecondClock = std::int64_t (*)();
std::int64_t milliseconds_now();
/// From now on `interrupt_requested` is true once `seconds` have passed; call it before there are threads. `typed`: the
/// limit in the user's words, for messages.
void begin_time_limit(double seconds, const std::string& typed, MillisecondClock clock = milliseconds_now);
/// Later work has no limit; Ctrl-C still ends it.
void lift_time_limit();
/// Whether the limit was reached at any time, lifted or not.
bool time_limit_was_reached();
/// "stopped by --time-limit 5 min".
std::string stopped_by_time_limit();

}  // namespace lacuna
