#pragma once

#include "foundation/text/problem.h"
#include "storage/core/database.h"
#include "storage/core/records.h"

#include <filesystem>
#include <functional>
#include <vector>

namespace lacuna {

/// What a shard that cannot be merged does to the others.
enum class Unusable { refuses_all, is_left_out };

/// A database whose runs are to be taken in.
struct Shard {
  std::filesystem::path file;
  Unusable unusable = Unusable::refuses_all;
};

/// What became of a shard's runs.
struct MergedShard {
  std::vector<RunId> added;       ///< by the numbers that they have got
  std::vector<RunId> known;       ///< by those of the shard: they were there
  std::vector<Problem> problems;  ///< why it was left out; empty: it was merged
  bool is_unsound = false;        ///< its rows differ from what was stored; making it again would help
};

/// Takes the runs of other databases in, those that are not there yet (by their identity), in one transaction each:
/// every row with every bit, run numbers and what is numbered by them aside. What runs share, such as trials, is there
/// once. Runs that were sealed are sealed anew. A shard cannot be merged where it is no database of this program, is of
/// a newer version, does not hold what was stored in it (seal.h), has more of a run that is there, or in a shard before
/// it, but not done, or where runs of one experiment, there and here, used different builds of a plugin. Such shards
/// are told with every problem, all of them before anything is written: by `BadInput`, or each in its place. Throws
/// `BadInput`, too, where a run of the database is being carried out, and `Interrupted`. `progress` gets the part that
/// is done, 0 to 1.
std::vector<MergedShard> merge(Database& into, const std::vector<Shard>& shards,
                               const std::function<void(double)>& progress = {});

}  // namespace lacuna
