#pragma once

#include <lacuna/plugin.h>

#include <string>

namespace lacuna {

/// The handshake: the fault of the table that a plugin returned, and what to do; empty: none. Reads plain data only and
/// calls nothing of the plugin. Of a table with another interface version only the version is read.
std::string table_problem(const PluginTable* table);

}  // namespace lacuna
