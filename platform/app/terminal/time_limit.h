#pragma once

#include <string>

namespace CLI {
class App;
}

namespace lacuna {

/// Seconds of a duration as typed: "90", "5 min", "1.5 h". Throws `BadInput` where it is none, or not above 0.
double parse_time_limit(const std::string& text);

/// Adds --time-limit, which counts from when it is read.
void add_time_limit_option(CLI::App& command);

}  // namespace lacuna
