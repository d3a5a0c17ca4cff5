#pragma once

#include "storage/core/database.h"
#include "storage/core/records.h"

#include <filesystem>
#include <functional>
#include <vector>

namespace lacuna {

/// What became of a shard's runs.
struct MergedShard {
  std::vector<RunId> added;  ///< by the numbers that they have got
  std::vector<RunId> known;  ///< by those of the shard: they were there
};

/// Takes the runs of other databases in, those that are not there yet (by their identity), in one transaction each:
/// every row with every bit, run numbers and what is numbered by them aside. What runs share, such as trials, is there
/// once. Runs that were sealed are sealed anew. Throws before anything is written: `BadInput` with every problem where
/// a file is no database of this program, is of a newer version, does not hold what was stored in it (seal.h), has more
/// of a run that is there but not done, or where runs of one experiment, there and here, used different builds of a
/// plugin; `Interrupted`. `progress` gets the part that is done, 0 to 1.
std::vector<MergedShard> merge(Database& into, const std::vector<std::filesystem::path>& shards,
                               const std::function<void(double)>& progress = {});

}  // namespace lacuna
