#pragma once

#include "measured_rigs/accepted_answer.h"
#include "runs/user_session.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hidden_effects {

/// What the program made of one experiment of a measured rig.
struct RigResult {
  const AcceptedAnswer* accepted = nullptr;
  std::string experiment;  ///< file
  std::string failure;     ///< a sentence; empty: there is a diagnosis
  std::optional<DiagnosisRecord> diagnosis;
  double seconds = kUnknown;     ///< of the whole command, the fit of the model included
  double over_check = kUnknown;  ///< held-out error of the answer over that of the check's model (set_scores.h)
};

/// Diagnoses an experiment in a folder that holds it and the robots, as a user would: default settings. A result of an
/// earlier call with the same program, kept beside the experiment, is taken as it is. `identity`: of the program.
RigResult run_rig(const AcceptedAnswer& accepted, const std::string& experiment, const std::filesystem::path& folder,
                  const ProgramSettings& settings, const std::string& identity);

/// Markdown: an experiment a row, with its grade, the answer, how much it lowers the error where it was not fitted and
/// on what is held out, what that is over the check's, and seconds; then how many rigs are right. A rig is right where
/// all of its experiments are.
std::string table_of(const std::vector<RigResult>& results);

}  // namespace hidden_effects
