#include "runs/run_case.h"

#include "cases/make_case.h"
#include "cases/write_case.h"
#include "runs/ask_baselines.h"
#include "runs/ask_oracle.h"
#include "runs/case_folder.h"
#include "runs/case_loop.h"
#include "runs/case_truth.h"
#include "runs/run_contact_case.h"
#include "runs/settle.h"
#include "runs/truth_error.h"

#include <exception>
#include <optional>
#include <stdexcept>

namespace hidden_effects {
namespace {

/// A case whose truth runs away nearby has no oracle.
OracleRecord oracle_of(const MadeCase& made, const std::vector<DiagnosisRecord>& told) {
  try {
    return oracle_record(made, told);
  } catch (const std::runtime_error&) {
    return {};
  }
}

/// Asked again with the answer at hand, the oracle may find more that is alike.
OracleRecord oracle_after(const MadeCase& made, const std::vector<DiagnosisRecord>& told, OracleRecord before) {
  if (!before.widths.empty() && told.empty()) return before;
  OracleRecord after = oracle_of(made, told);
  return after.widths.empty() ? before : after;
}

/// A case whose truth cannot be predicted (it runs away) has no such error.
void add_truth_error(const MadeCase& made, CaseResult& result) {
  try {
    const std::vector<HeldOutRecord> errors = truth_held_out(made);
    result.held_out.insert(result.held_out.end(), errors.begin(), errors.end());
  } catch (const std::runtime_error&) {
  }
}

/// Data that the base cannot follow at all leave the baselines without an answer.
void add_baselines(const MadeCase& made, const std::vector<std::string>& withheld, CaseResult& result) {
  try {
    result.baselines = ask_baselines(made, withheld);
  } catch (const std::runtime_error&) {
  }
}

}  // namespace

CaseResult run_case(const CasePlan& plan, const std::string& version, const RunCaseOptions& options,
                    const ProgramSettings& settings) {
  const CaseFolder folder(options.work / plan.name(), options.keep);
  if (is_contact_case(plan)) return run_contact_case(plan, version, folder.path(), settings);
  std::optional<MadeCase> made;
  try {
    made = make_case(plan);
  } catch (const std::exception& error) {
    return {
        about_plan(plan, version), std::string("the case cannot be made: ") + error.what(), {}, {}, {}, {}, {}, {}, {}};
  }
  write_case(*made, folder.path());
  const CaseRecord about = about_case(*made, version);
  const bool withholds = about.group == "withheld";
  const OracleRecord before = options.oracle && withholds ? oracle_of(*made, {}) : OracleRecord{};
  const std::vector<std::string> withheld = withholds ? class_effects(about, before) : std::vector<std::string>();
  CaseResult result = go_through({about, folder.path(), true_free_values(*made), withheld}, settings);
  if (options.oracle) result.oracle = oracle_after(*made, result.diagnoses, before);
  add_truth_error(*made, result);
  if (options.baselines) add_baselines(*made, withheld, result);
  if (options.settle && !result.diagnoses.empty())
    result.settling = settle(*made, result.diagnoses.front(), folder.path(), settings);
  return result;
}

}  // namespace hidden_effects
