#include "runs/run_dirty_case.h"

#include "dirty/write_dirty_case.h"
#include "runs/case_folder.h"
#include "runs/dirty_truth.h"

#include <exception>

namespace hidden_effects {
namespace {

/// Names of the effects that the library is not to have: all that could stand for a main effect.
std::vector<std::string> withheld_effects(const CaseResult& made, const CasePlan& plan) {
  std::vector<std::string> names;
  if (!dirty_plan_of(plan).withheld) return names;
  for (const DirtyEffectRecord& effect : made.dirty) {
    if (effect.role != "main") continue;
    const std::vector<std::string> alike = effects_like(dirty::dirty_kind(effect.what));
    names.insert(names.end(), alike.begin(), alike.end());
  }
  return names;
}

}  // namespace

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
    result.diagnoses.push_back(UserSession(settings, folder.path(), withheld_effects(result, plan)).diagnose());
  } catch (const CaseFailure& error) {
    result.failure = error.what();
  }
  return result;
}

}  // namespace hidden_effects
