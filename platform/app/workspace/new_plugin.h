#pragma once

namespace CLI {
class App;
}

namespace lacuna {

/// Adds `new` to the command `plugins`: it writes the folder of a plugin of any kind.
void add_new_plugin_command(CLI::App& plugins);

}  // namespace lacuna
