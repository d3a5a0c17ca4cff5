#pragma once

#include "runs/case_failure.h"
#include "runs/child_process.h"
#include "runs/read_results.h"
#include "runs/records.h"

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace hidden_effects {

/// How the program is run.
struct ProgramSettings {
  std::filesystem::path lacuna;  ///< the program, absolute
  double longest = 1800.0;       ///< s, of one call
  int most_diagnoses = 3;        ///< of one case, with the effects of all but the last added
  std::function<bool()> stop = [] { return false; };
};

/// `lacuna` as a user runs it on the `rig.toml` of a folder, one command after the other, with one thread and a
/// database there. Throws `CaseFailure`, `CaseStopped`.
class UserSession {
 public:
  /// `withheld`: names of effects that the library is not to have.
  UserSession(ProgramSettings settings, std::filesystem::path folder, std::vector<std::string> withheld);

  DiagnosisRecord diagnose();
  /// With these effects alone.
  DiagnosisRecord diagnose_among(const std::vector<std::string>& effects);
  /// Writes the commands of a test, a line as `lacuna trial --test` takes it, as CSV.
  void write_commands(const std::string& test, const std::string& file);
  void add(const EffectAt& what);
  ReadComparison compare();

 private:
  ChildOutcome call(std::vector<std::string> words);
  std::string expect_json(std::vector<std::string> words, ChildOutcome& outcome);
  std::vector<std::string> library();
  DiagnosisRecord read(const std::string& json, const ChildOutcome& outcome) const;

  ProgramSettings settings_;
  std::filesystem::path folder_;
  std::vector<std::string> withheld_;
};

/// What `lacuna --version` prints.
std::string program_version(const ProgramSettings& settings, const std::filesystem::path& folder);

}  // namespace hidden_effects
