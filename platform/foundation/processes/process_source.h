#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// How an outside program is run as a target: what `[target]` of kind "process" says.
struct ProcessSource {
  std::vector<std::string> command;                ///< the program and its arguments
  std::filesystem::path folder;                    ///< that it works in
  std::map<std::string, std::string> environment;  ///< variables besides those of Lacuna
  double start_limit = 10.0;                       ///< s, until it has said hello
  double trial_limit = 60.0;                       ///< s, of a trial beyond the test's duration
  int repeats = 1;                                 ///< how often a test is tried again after it failed
  double pause = 1.0;                              ///< s, between a test that failed and the next attempt
  int copies = 1;                                  ///< how many of it may run side by side
  std::string refused;                             ///< why it may not be started, a sentence; empty: it may
  std::string version;                             ///< trials of another one are another target's
};

}  // namespace lacuna
