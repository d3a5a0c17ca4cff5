#pragma once

namespace lacuna {

/// Decrease of the prediction error of one model against another, on data to which neither was fitted, nats.
struct Gain {
  double value = 0.0;
  double standard_error = 0.0;
  double lower_95 = 0.0, upper_95 = 0.0;
  bool operator==(const Gain&) const = default;
};

}  // namespace lacuna
