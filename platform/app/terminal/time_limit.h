#pragma once

#include "app/terminal/options.h"

#include <string>

namespace CLI {
class App;
}

namespace lacuna {

/// Seconds of a duration as typed for an option: "90", "5 min", "1.5 h". Throws `BadInput` where it is none, or not
/// above 0.
double parse_duration(const std::string& option, const std::string& text);

/// Adds --time-limit, which counts from when it is read. The options must live as long as the command.
void add_time_limit_option(CLI::App& command, CommonOptions& options);

/// From now on an evaluation takes two minutes at most, unless --evaluation-limit says otherwise.
void begin_evaluation_limit();
/// Adds --evaluation-limit: the program ends itself where an evaluation takes longer.
void add_evaluation_limit_option(CLI::App& command);

}  // namespace lacuna
