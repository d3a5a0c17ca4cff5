#pragma once

#include <string>

namespace lacuna {

/// An error over its noise floor: "0.9", "17.1", "213", ">1000", where only the order of magnitude says something;
/// "-" where either is not known.
std::string times_floor_text(double factor);

}  // namespace lacuna
