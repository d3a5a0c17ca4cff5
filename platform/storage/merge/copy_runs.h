#pragma once

#include "storage/merge/renumbering.h"

namespace lacuna {

/// Copies the rows of the runs that a renumbering has, inside a transaction of `into`.
void copy_runs(const Database& shard, Database& into, const Renumbering& numbers);

}  // namespace lacuna
