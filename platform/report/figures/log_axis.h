#pragma once

#include <string>
#include <vector>

namespace lacuna {

/// Where a logarithmic axis from `low` to `high` is numbered: at powers of ten, with others between them where there
/// are few, at round numbers as of a linear axis where the ends are close. `apart`: the least distance of two numbers,
/// as a share of the axis.
std::vector<double> log_ticks(double low, double high, double apart);

/// "0.002", "1e-07".
std::string log_tick_text(double tick);

/// gnuplot's commands for a logarithmic axis ("x" or "y") of `length` px around values from `low` to `high`; without
/// numbers where it is not `numbered`. Nothing where there is no value above 0.
std::string log_axis(char axis, double low, double high, double length, bool numbered);

}  // namespace lacuna
