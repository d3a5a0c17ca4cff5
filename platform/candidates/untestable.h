#pragma once

#include <string>

namespace lacuna {

/// Why an effect is not tested.
struct Untestable {
  std::string effect;
  std::string where;  ///< empty: nowhere
  std::string reason;
  bool failed = false;  ///< its plugin failed; else no place in this model, or no influence on these trials
  bool operator==(const Untestable&) const = default;
};

}  // namespace lacuna
