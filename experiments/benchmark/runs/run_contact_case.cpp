#include "runs/run_contact_case.h"

#include "contacts/write_contact_case.h"
#include "runs/case_loop.h"
#include "runs/case_truth.h"

#include <exception>
#include <optional>

namespace hidden_effects {
namespace {

namespace fs = std::filesystem;

/// `lacuna compare` with the true law in the model, beside the case. Nothing where the library has no such law.
std::vector<HeldOutRecord> truth_by_program(const MadeContactCase& made, const fs::path& folder,
                                            const ProgramSettings& settings) {
  if (made.hidden && !made.hidden->law.library_form()) return {};
  const fs::path beside = folder / "truth";
  write_contact_robot(*made.rig, beside);
  write_contact_case(made, beside, made.hidden ? std::vector{*made.hidden} : std::vector<SizedContactLaw>{});
  std::vector<HeldOutRecord> errors;
  for (const NamedValue& one : UserSession(settings, beside, {}).compare().held_out)
    errors.push_back({"truth", one.name, one.value});
  return errors;
}

}  // namespace

std::vector<HiddenLawRecord> hidden_contact_laws(const CasePlan& plan) {
  const std::optional<ContactLaw> law = hidden_law(plan);
  if (!law) return {};
  return {{law->name, {law->effect, law->where.empty() ? "world" : law->where}, law->library_form(), {}}};
}

CaseRecord about_contact_case(const MadeContactCase& made, const std::string& version) {
  CaseRecord about = about_plan(made.plan, version);
  about.strength = made.strength;
  about.absorbed = made.absorbed;
  if (made.hidden) about.hidden.front().parameters.push_back({made.hidden->law.parameter, made.hidden->value});
  return about;
}

std::vector<NamedValue> true_contact_values(const MadeContactCase& made) { return {{made.rig->free, made.free_value}}; }

CaseResult run_contact_case(const CasePlan& plan, const std::string& version, const fs::path& folder,
                            const ProgramSettings& settings) {
  std::optional<MadeContactCase> made;
  try {
    made = make_contact_case(plan, folder);
  } catch (const std::exception& error) {
    return {
        about_plan(plan, version), std::string("the case cannot be made: ") + error.what(), {}, {}, {}, {}, {}, {}, {}};
  }
  CaseResult result =
      go_through({about_contact_case(*made, version), folder, true_contact_values(*made), {}}, settings);
  try {
    const std::vector<HeldOutRecord> errors = truth_by_program(*made, folder, settings);
    result.held_out.insert(result.held_out.end(), errors.begin(), errors.end());
  } catch (const CaseStopped&) {
    throw;
  } catch (const std::runtime_error&) {
    // A true law that the program cannot fit has no such error.
  }
  return result;
}

}  // namespace hidden_effects
