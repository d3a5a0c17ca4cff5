#pragma once

#include "fitting/fit.h"

#include <string>

namespace lacuna {

/// Significant digits with which `width` shows two of its own in numbers of the size of `value`; 3 at least.
int interval_digits(double value, double width);

/// A fitted value and its 95 % interval with as many digits as the interval's width deserves.
struct IntervalText {
  std::string value;     ///< "0.0241"
  std::string interval;  ///< "[0.0240, 0.0242]", "at its lower bound", "not determined"; "": not fitted
};
IntervalText interval_text(const FittedValue& value);

}  // namespace lacuna
