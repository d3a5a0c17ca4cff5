#pragma once

#include <filesystem>
#include <string>

namespace lacuna {

/// Whether a file is a database of SQLite.
bool is_database(const std::filesystem::path& file);

/// Throws `BadInput` with the line to type where a database was named in place of an experiment file.
void refuse_database_as_experiment(const std::string& file);

/// The same for an experiment file in place of its database.
void refuse_experiment_as_database(const std::string& file);

}  // namespace lacuna
