#pragma once

#include "runs/records.h"

#include <filesystem>
#include <string>
#include <vector>

namespace hidden_effects {

/// Effects that are right in one place of an answer, each "effect" or "effect @ place".
using Alternatives = std::vector<std::string>;

/// What a diagnosis of a measured rig must find, fixed before any method saw it.
struct AcceptedAnswer {
  std::string rig;
  std::vector<std::string> experiments;      ///< files that lack something
  std::vector<std::string> nothing_missing;  ///< files that lack nothing
  std::vector<Alternatives> needs;           ///< one of each
  Alternatives may;                          ///< right beside these
  std::vector<std::string> check = {};       ///< the model of an independent check, "effect @ place" of each effect
};

/// Reads measured_rigs/answers.toml. Throws `std::runtime_error` for a file that is not that.
std::vector<AcceptedAnswer> read_accepted_answers(const std::filesystem::path& file);

enum class Grade {
  right,
  wrong,
  undecided  ///< `cannot_tell`: wrong, too, where the data can tell
};

/// Right: of each alternatives one is in the answer, or among what the data do not tell from it, and no effect of the
/// answer is neither needed nor allowed nor stands for such a one.
Grade grade(const AcceptedAnswer& accepted, const std::string& experiment, const DiagnosisRecord& diagnosis);

}  // namespace hidden_effects
