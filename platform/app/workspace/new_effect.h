#pragma once

namespace CLI {
class App;
}

namespace lacuna {

/// Adds `new effect` to the command `plugins`: it writes the folder of a plugin from a formula.
void add_new_effect_command(CLI::App& plugins);

}  // namespace lacuna
