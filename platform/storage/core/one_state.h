#pragma once

#include "storage/core/database.h"

namespace lacuna {

/// From now on the connection sees one state of the file, whatever others commit.
void hold_one_state(const Database& database);

}  // namespace lacuna
