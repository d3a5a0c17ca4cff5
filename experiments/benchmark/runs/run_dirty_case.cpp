#include "runs/run_dirty_case.h"

#include "dirty/write_dirty_case.h"
#include "runs/case_folder.h"
#include "runs/dirty_truth.h"

#include <exception>

namespace hidden_effects {

CaseResult run_dirty_case(const CasePlan& plan, const std::string& version, const std::filesystem::path& work,
                          bool keep, const ProgramSettings& settings) {
  const CaseFolder folder(work / plan.name(), keep);
  CaseResult result;
  result.about = about_dirty_plan(plan, version);
  try {
    const dirty::DirtyCase made = dirty::make_dirty_case(dirty_plan_of(plan));
    dirty::write_dirty_case(made, folder.path());
    result.about = about_dirty_case(made, plan, version);
    result.dirty = dirty_effects(made);
  } catch (const std::exception& error) {
    result.failure = std::string("the case cannot be made: ") + error.what();
    return result;
  }
  try {
    result.diagnoses.push_back(UserSession(settings, folder.path(), {}).diagnose());
  } catch (const CaseFailure& error) {
    result.failure = error.what();
  }
  return result;
}

}  // namespace hidden_effects
