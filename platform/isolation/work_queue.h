#pragma once

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <numeric>
#include <vector>

namespace lacuna {

/// Hands out pieces of work to several workers: large parts first, single pieces at the end, so that all finish at
/// about the same time with few messages. Shared by threads.
class WorkQueue {
 public:
  WorkQueue(std::size_t count, std::size_t workers) : left_(count), workers_(workers) {
    std::iota(left_.rbegin(), left_.rend(), std::size_t{0});
  }

  /// Empty: no work is left.
  std::vector<std::size_t> take() {
    const std::scoped_lock lock(mutex_);
    const std::size_t wanted = std::max<std::size_t>(1, left_.size() / (kParts * workers_));
    std::vector<std::size_t> part;
    while (part.size() < wanted && !left_.empty()) {
      part.push_back(left_.back());
      left_.pop_back();
    }
    return part;
  }
  void put_back(const std::vector<std::size_t>& part) {
    const std::scoped_lock lock(mutex_);
    left_.insert(left_.end(), part.rbegin(), part.rend());
  }
  /// Hands out nothing more.
  void close() {
    const std::scoped_lock lock(mutex_);
    left_.clear();
  }

 private:
  static constexpr std::size_t kParts = 4;

  std::mutex mutex_;
  std::vector<std::size_t> left_;  ///< index of the next piece, at the end
  std::size_t workers_;
};

}  // namespace lacuna
