#pragma once

#include "app/terminal/supervised.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace lacuna {

/// What a process that carries a task out leaves to the one that watches it, should it end before it has handed its
/// results in.
struct TaskLeft {
  std::filesystem::path folder;  ///< of the plan
  std::size_t number = 0;
  std::filesystem::path scratch;  ///< where its database is

  std::string text() const;
};

/// The sentence for what could not be brought to the plan's folder.
std::string where_it_stays(const std::filesystem::path& folder, std::size_t number,
                           const std::filesystem::path& scratch);

/// For the process that watches: prints what became of the other one and, where that had a task, hands in what it has
/// found and notes that the task failed or was interrupted.
void report_loss(const ChildLoss& loss);

}  // namespace lacuna
