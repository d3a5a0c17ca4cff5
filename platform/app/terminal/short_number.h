#pragma once

#include <fmt/format.h>

#include <string>

namespace lacuna {

/// To four digits, as a person would write it into a file.
inline double short_number(double value) { return std::stod(fmt::format("{:.4g}", value)); }

}  // namespace lacuna
