#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <limits>

namespace lacuna {

/// Takes whole numbers from `lower` to `upper`. CLI11's own checks would take -3 for 2^64 - 3.
CLI::Validator whole_number(std::uint64_t lower, std::uint64_t upper = std::numeric_limits<std::uint64_t>::max());

}  // namespace lacuna
