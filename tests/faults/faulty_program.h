#pragma once

#include "end_to_end/program.h"

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace lacuna {

/// One call that fails (failing_calls.h).
struct Fault {
  bool allocation = false;
  bool lasting = false;
  std::uint64_t at = 1;  ///< the number of the call, from 1 on
};
std::string text_of(const Fault& fault);

/// What a command did while a call failed.
struct FaultyOutcome : Outcome {
  bool met = false;  ///< the command came to that call
};

/// The program in a folder that is put back before each command, in which calls fail.
class FaultyProgram {
 public:
  /// Keeps what `prepared` has in its folder now.
  explicit FaultyProgram(const Program& prepared);

  const Program& program() const { return program_; }
  /// Calls of one kind that the command makes where none fails.
  std::uint64_t count(const std::string& command, bool allocations);
  /// In the folder as it was prepared.
  FaultyOutcome run(const std::string& command, const Fault& fault);
  /// Names in the folder that it had not when it was prepared, without SQLite's logs, which the next writer ends.
  std::set<std::string> new_names() const;

 private:
  void put_back() const;
  FaultyOutcome run_in_folder(const std::string& command, const std::string& variables);

  Program program_;
  Program kept_;  ///< owns these two
  std::filesystem::path prepared_, count_;
};

/// The faults that a test goes through: each of them where LACUNA_ALL_FAULTS is set, else `most` of each kind, evenly
/// spread and others for each seed in LACUNA_FAULTS_SEED.
std::vector<Fault> faults_to_try(std::uint64_t count, bool allocations, std::uint64_t most);

}  // namespace lacuna
