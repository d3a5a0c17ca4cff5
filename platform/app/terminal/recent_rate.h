#pragma once

#include <cstdint>
#include <deque>

namespace lacuna {

/// How fast something is counted up lately: over the last ten seconds, or as long as it has been counted.
class RecentRate {
 public:
  /// `time`: s, not falling; `total`: counted so far.
  void note(double time, std::uint64_t total);
  /// Per second; 0 where less than two moments are known.
  double per_second() const;

 private:
  struct Moment {
    double time;
    std::uint64_t total;
  };
  std::deque<Moment> moments_;
};

}  // namespace lacuna
