#pragma once

#include <string>
#include <vector>

namespace lacuna {

/// Differences of the rig in some of its tests, such as a load or a gain: values that a model has in these tests
/// instead of its usual ones. Tests name their setup.
struct Setup {
  struct Value {
    std::string address;  ///< `body.load.mass`; in a file, a pattern such as `body.*.mass`
    double value = 0.0;   ///< SI
    bool operator==(const Value&) const = default;
  };
  std::string name;  ///< empty: no differences
  std::vector<Value> values = {};
  bool operator==(const Setup&) const = default;
};

}  // namespace lacuna
