#pragma once

#include "contacts/contact_case.h"
#include "runs/records.h"
#include "runs/user_session.h"

namespace hidden_effects {

/// What a contact case hides, without its size; empty: nothing.
std::vector<HiddenLawRecord> hidden_contact_laws(const CasePlan& plan);

/// The whole of it.
CaseRecord about_contact_case(const MadeContactCase& made, const std::string& version);

/// The true value of what the case's user frees.
std::vector<NamedValue> true_contact_values(const MadeContactCase& made);

/// Makes a contact case in `folder` and sends it through the program. The planar oracle and the baselines do not apply;
/// the held-out error of the true law, refitted, is the program's own. Throws `CaseStopped`.
CaseResult run_contact_case(const CasePlan& plan, const std::string& version, const std::filesystem::path& folder,
                            const ProgramSettings& settings);

}  // namespace hidden_effects
