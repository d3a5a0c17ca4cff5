#include "app/terminal/recent_rate.h"

namespace lacuna {
namespace {

constexpr double kWindow = 10.0;  // s
constexpr double kApart = 0.1;    // s; moments that are closer replace each other

}  // namespace

void RecentRate::note(double time, std::uint64_t total) {
  if (moments_.size() > 1 && time - moments_[moments_.size() - 2].time < kApart) moments_.pop_back();
  moments_.push_back({time, total});
  while (moments_.size() > 2 && time - moments_[1].time >= kWindow) moments_.pop_front();
}

double RecentRate::per_second() const {
  if (moments_.size() < 2) return 0.0;
  const double seconds = moments_.back().time - moments_.front().time;
  return seconds > 0.0 ? static_cast<double>(moments_.back().total - moments_.front().total) / seconds : 0.0;
}

}  // namespace lacuna
