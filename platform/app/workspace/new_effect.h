#pragma once

namespace CLI {
class App;
}

namespace lacuna {

/// Adds `effect` to the command `plugins new`: it writes the folder of a plugin from a formula.
void add_new_effect_command(CLI::App& made);

}  // namespace lacuna
