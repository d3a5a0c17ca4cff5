#pragma once

#include <stdexcept>

namespace lacuna::rosbag2 {

/// Why a bag, a message or a definition is unusable: where, what, and what to do.
class BadBag : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace lacuna::rosbag2
