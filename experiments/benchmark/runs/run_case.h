#pragma once

#include "cases/case_plan.h"
#include "runs/records.h"
#include "runs/user_session.h"

#include <filesystem>
#include <string>

namespace hidden_effects {

struct RunCaseOptions {
  std::filesystem::path work;  ///< folder for the files of cases under way
  bool keep = false;           ///< these files
  bool oracle = true;          ///< ask what the data could tell at all
  bool baselines = false;      ///< ask the other methods, too, which takes about as long as a diagnosis
  bool settle = false;         ///< carry out tests that tell the answer from its closest look-alike
};

/// Makes a case in `work`/its name, sends it through the program, and removes the folder unless it is to be kept.
/// A case that cannot be made is a result with its reason, too. Throws `CaseStopped`.
CaseResult run_case(const CasePlan& plan, const std::string& version, const RunCaseOptions& options,
                    const ProgramSettings& settings);

}  // namespace hidden_effects
