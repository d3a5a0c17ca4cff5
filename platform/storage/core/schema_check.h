#pragma once

#include "storage/core/database.h"

#include <string>
#include <vector>

namespace lacuna {

/// Tables, indices and views of a database that are not as this program makes them, "table model": changed or gone.
/// Views that another program of the same schema made are not looked at, for whoever writes next makes them anew.
std::vector<std::string> changed_schema(const Database& database);

}  // namespace lacuna
