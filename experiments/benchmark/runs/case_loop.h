#pragma once

#include "runs/records.h"
#include "runs/user_session.h"

#include <filesystem>
#include <string>
#include <vector>

namespace hidden_effects {

/// A written case that is to go through the program.
struct CaseTask {
  CaseRecord about;
  std::filesystem::path folder;         ///< with rig.toml
  std::vector<NamedValue> free_values;  ///< true ones, by address
  std::vector<std::string> withheld;    ///< effects that the library is not to have
};

/// Compare, diagnose, add what was found, diagnose again, until nothing more is found or there were `most_diagnoses`;
/// then compare again. What goes wrong with the program ends up in `failure`. Throws `CaseStopped`.
CaseResult go_through(const CaseTask& task, const ProgramSettings& settings);

}  // namespace hidden_effects
