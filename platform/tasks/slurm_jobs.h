#pragma once

#include "tasks/task_folder.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// Numbers as `sbatch --array` takes them: "0-3,7".
std::string array_of(const std::vector<std::size_t>& numbers);

/// The words of a line, parted at spaces outside of quotes. Throws `Error` where a quote is not closed.
std::vector<std::string> words_of(const std::string& line);

/// The jobs that Slurm has been given.
struct SlurmJobs {
  std::string array, merge;  ///< their numbers
};

/// Writes a script for the tasks and one for the merge into the folder, and submits an array of the tasks that are not
/// done and a merge that begins when all of these have ended, however they did. `program`: the file of this one;
/// `options`: further ones of `sbatch`, for both; `database`: into which it is merged. Throws `Error` with what
/// `sbatch` says where it refuses.
SlurmJobs submit_to_slurm(const TaskFolder& folder, const std::filesystem::path& program,
                          const std::vector<std::string>& options, const std::filesystem::path& database);

}  // namespace lacuna
