#pragma once

#include "foundation/unit.h"

#include <string>
#include <string_view>

namespace lacuna {

/// A physical quantity as written in a text: "95.1 kg", "120 mm", "-3 deg", "35.15065 N/V", "1e-3".
struct Quantity {
  double value_in_si = 0.0;
  std::string unit;  ///< as written; "1" where the text has none
  Unit parsed;
};

/// Throws `Error` with what is wrong: no number, no such unit, or out of the range of a double.
Quantity parse_quantity(std::string_view text);

}  // namespace lacuna
