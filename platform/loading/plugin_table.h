#pragma once

#include <lacuna/plugin.h>

#include <string>

namespace lacuna {

/// The handshake: what is wrong with the table that a plugin returned, and what to do; empty: nothing.
/// Looks at plain data only and calls nothing of the plugin. A table of another interface version is
/// read no further than its version.
std::string table_problem(const PluginTable* table);

}  // namespace lacuna
