#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace hidden_effects {

struct ChildOutcome {
  int code = 0;  ///< of the exit; 128 + signal where one ended it
  bool timed_out = false;
  bool stopped = false;  ///< because somebody asked for it
  double seconds = 0.0;
  double processor_seconds = 0.0;
  std::string output, errors;  ///< the last 64 KiB of each
};

/// Runs `words` (the program first, with its path) in `folder` and waits for it. A child that takes longer than
/// `longest` s, or is still there when `stop` says so, is ended with all of its own children. Throws
/// `std::runtime_error` where it cannot be started.
ChildOutcome run_child(const std::vector<std::string>& words, const std::filesystem::path& folder, double longest,
                       const std::function<bool()>& stop);

}  // namespace hidden_effects
