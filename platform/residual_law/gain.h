#pragma once

namespace lacuna {

/// By how much one model predicts what was not fitted better than another, nats.
struct Gain {
  double value = 0.0;
  double standard_error = 0.0;
  double lower_95 = 0.0, upper_95 = 0.0;
  bool operator==(const Gain&) const = default;
};

}  // namespace lacuna
