#pragma once

#include <string>
#include <vector>

namespace lacuna {

/// What was different on the rig in some of its tests, such as a load or a gain: values that a model has in these tests
/// instead of its own. Tests name their setup.
struct Setup {
  struct Value {
    std::string address;  ///< `body.load.mass`; where a file states it, a pattern such as `body.*.mass`
    double value = 0.0;   ///< SI
    bool operator==(const Value&) const = default;
  };
  std::string name;  ///< empty: nothing was different
  std::vector<Value> values = {};
  bool operator==(const Setup&) const = default;
};

}  // namespace lacuna
