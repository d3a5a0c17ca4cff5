#pragma once

#include "fitting/fit.h"

#include <string>

namespace lacuna {

/// A fitted value and its 95 % interval with as many digits as the interval's width deserves.
struct IntervalText {
  std::string value;     ///< "0.0241"
  std::string interval;  ///< "[0.0240, 0.0242]", "at its lower bound", "not told by the data"; "": not fitted
};
IntervalText interval_text(const FittedValue& value);

}  // namespace lacuna
