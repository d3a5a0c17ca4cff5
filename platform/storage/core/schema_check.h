#pragma once

#include "storage/core/database.h"

#include <string>
#include <vector>

namespace lacuna {

/// Tables, indices and views of a database that are not as this program makes them, "table model": changed or gone.
/// Views are not compared, because the next writer of the same schema makes them again.
std::vector<std::string> changed_schema(const Database& database);

}  // namespace lacuna
