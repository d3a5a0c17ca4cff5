#pragma once

#include <lacuna/error.h>

#include <atomic>
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

/// Milliseconds of a monotonic clock.
using MillisecondClock = std::int64_t (*)();
std::int64_t milliseconds_now();

/// A request that work ends early; nobody takes it back. A signal handler may make it, and any thread may read it.
class StopRequest {
 public:
  /// Returns the time of the first request, ms: `now` where there was none.
  std::int64_t make(std::int64_t now = milliseconds_now()) noexcept;
  /// The time of the first request, ms; 0: none.
  std::int64_t made_at() const noexcept { return at_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::int64_t> at_ = 0;
  static_assert(std::atomic<std::int64_t>::is_always_lock_free);
};

/// The time that one piece of work may take, from the construction of this object on. Any thread may read it.
class TimeLimit {
 public:
  /// `typed`: the limit in the user's words, for messages.
  TimeLimit(double seconds, std::string typed, MillisecondClock clock = milliseconds_now);

  /// Whether the time is over and the limit not lifted.
  bool is_over() const;
  /// Later work has no limit.
  void lift();
  /// Whether `is_over` was true at any time, lifted or not.
  bool was_reached() const { return reached_; }
  /// "stopped by --time-limit 5 min".
  std::string in_words() const { return "stopped by --time-limit " + typed_; }

 private:
  MillisecondClock clock_;
  std::string typed_;
  std::atomic<std::int64_t> deadline_;  ///< ms
  mutable std::atomic<bool> reached_ = false;
};

/// What ends a piece of work early: a request, and the work's own time limit. It refers to both, which must outlive it,
/// and is passed by value to whatever belongs to the work. Without either, nothing ends the work early.
class Stop {
 public:
  Stop() = default;
  explicit Stop(const StopRequest& request) : request_(&request) {}
  explicit Stop(TimeLimit& limit) : limit_(&limit) {}

  /// By the same request, and by this limit.
  Stop within(TimeLimit& limit) const {
    Stop limited = *this;
    limited.limit_ = &limit;
    return limited;
  }
  bool has_limit() const { return limit_ != nullptr; }

  /// Whether a request was made, or the time limit is reached and not lifted.
  bool is_due() const { return is_requested() || (limit_ != nullptr && limit_->is_over()); }
  /// Throws `Interrupted` after a request, `TimeIsUp` where the limit is reached and not lifted. Long work calls it
  /// between its steps.
  void throw_if_due() const {
    if (is_due()) [[unlikely]]
      throw_reason();
  }
  /// The same without the time limit: for short work on which the rest depends.
  void throw_if_requested() const;
  /// The same after the user has waited for more than a second: for work that is usually short and useless if
  /// incomplete.
  void throw_if_kept_waiting() const {
    if (is_requested()) [[unlikely]]
      throw_if_requested_long_ago();
  }
  /// Sleeps; throws as `throw_if_due` does.
  void pause_for(double seconds) const;

  /// For a handler of `TimeIsUp`: later work has no limit; a request still ends it.
  void lift_limit() const;
  /// Whether the limit was reached at any time, lifted or not.
  bool limit_was_reached() const { return limit_ != nullptr && limit_->was_reached(); }
  /// "stopped by --time-limit 5 min"; "stopped" without a limit.
  std::string reason_of_limit() const { return limit_ != nullptr ? limit_->in_words() : "stopped"; }

 private:
  bool is_requested() const { return request_ != nullptr && request_->made_at() != 0; }
  void throw_reason() const;
  void throw_if_requested_long_ago() const;

  const StopRequest* request_ = nullptr;
  TimeLimit* limit_ = nullptr;
};

}  // namespace lacuna
