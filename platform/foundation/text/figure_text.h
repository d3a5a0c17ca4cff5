#pragma once

#include <string>

namespace lacuna {

/// A probability in all outputs: two digits, rounded down, so that none is printed as more than it is, and at most
/// 0.99, because no calibration has enough cases for more. "0.89", "< 0.01"; "-" where none is stated.
std::string probability_text(double probability);

/// Relative change of an error, "−87 %", "−94.3 %", "+40 %": it must not look like a multiple of the noise floor. The
/// remaining error has two significant digits. "–" where either is not known.
std::string error_change_text(double now, double then);

}  // namespace lacuna
