#pragma once

#include <string>

namespace lacuna {

/// A probability as every surface prints it: two digits, rounded down, so that none is printed as more than it is, and
/// at most 0.99: no calibration has the cases to tell more apart. "0.89", "< 0.01"; "-" where none is stated.
std::string probability_text(double probability);

/// By how much an error differs from an earlier one, "−87 %", "−94.3 %", "+40 %": never to be taken for a multiple of
/// the noise floor. Of what is left of an error two digits are told. "–" where either is not known.
std::string error_change_text(double now, double then);

}  // namespace lacuna
