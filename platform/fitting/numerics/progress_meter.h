#pragma once

#include "foundation/work.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <string>
#include <utility>

namespace lacuna {

/// Converts completed steps into `Progress`: equal parts, each with an unknown number of iterations.
class ProgressMeter {
 public:
  explicit ProgressMeter(const ProgressCallback& callback) : callback_(callback), begin_(Clock::now()) {}

  void set_parts(int parts) { parts_ = parts; }
  void add_parts(int parts) { parts_ += parts; }
  void begin_part(std::string what) {
    what_ = std::move(what);
    report(0);
  }
  void end_part() { ++done_; }
  /// Call after an iteration of the part. Their number is unknown: each takes a fifth of the remaining share.
  void report(int iteration) {
    if (!callback_) return;
    double left = 1.0;
    for (int i = 0; i < iteration; ++i) left *= 0.8;
    fraction_ =
        std::clamp((done_ + 1.0 - left) / parts_, fraction_, 1.0);  // a search may restart; progress never decreases
    const double left_seconds = seconds() * (1.0 - fraction_) / fraction_;
    callback_({what_, fraction_, fraction_ > 0.0 ? left_seconds : std::numeric_limits<double>::quiet_NaN()});
  }
  /// The part that was begun last.
  const std::string& what() const { return what_; }
  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  const ProgressCallback& callback_;
  Clock::time_point begin_;
  std::string what_;
  int parts_ = 1;
  int done_ = 0;
  double fraction_ = 0.0;
};

}  // namespace lacuna
