#pragma once

namespace CLI {
class App;
}

namespace lacuna {

/// Adds `check` to the command `plugins`: it tries a plugin library in processes of their own.
void add_check_plugin_command(CLI::App& plugins);

}  // namespace lacuna
