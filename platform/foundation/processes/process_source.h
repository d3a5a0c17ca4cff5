#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// Settings for an outside program as a target: `[target]` of kind "process".
struct ProcessSource {
  std::vector<std::string> command;                ///< the program and its arguments
  std::filesystem::path folder;                    ///< working folder
  std::map<std::string, std::string> environment;  ///< variables besides those of Lacuna
  double start_limit = 10.0;                       ///< s, for its hello message
  double trial_limit = 60.0;                       ///< s, for a trial beyond the test's duration
  int repeats = 1;                                 ///< how often a failed test is repeated
  double pause = 1.0;                              ///< s, between a failed test and the next attempt
  int copies = 1;                                  ///< how many instances may run side by side
  std::string refused;                             ///< why it must not be started, a sentence; empty: it may
  std::string version;                             ///< trials of another version belong to another target
};

}  // namespace lacuna
