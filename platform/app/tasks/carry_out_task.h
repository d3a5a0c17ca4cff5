#pragma once

#include "tasks/task_folder.h"

#include <cstddef>

namespace lacuna {

/// Carries a task of a plan out and puts its shard into the plan's folder. What it writes meanwhile lies in the folder
/// for temporary files ($TMPDIR). When it is interrupted, what it has goes to the plan's folder as a checkpoint, from
/// which the next one goes on, on any machine; `Interrupted` then says so. A task that is done is left as it is. Throws
/// `BadInput` where a file is not the one that the plan was made with.
void carry_out_task(const TaskFolder& folder, std::size_t number, int threads, bool quiet);

}  // namespace lacuna
