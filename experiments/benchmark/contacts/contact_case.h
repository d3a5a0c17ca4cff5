#pragma once

#include "contacts/contact_recording.h"

#include <optional>

namespace hidden_effects {

/// A contact case with its truth.
struct MadeContactCase {
  CasePlan plan;
  const ContactRig* rig = nullptr;  ///< of `contact_rigs`
  std::optional<SizedContactLaw> hidden;
  double free_value = 0.0;
  std::vector<ContactTrial> trials;  ///< fit trials, then held-out ones
  double strength = 1.0;             ///< RMSE of the refitted base over what a right model leaves
  bool absorbed = false;             ///< the base explains it: nothing is missing in these data
};

/// Whether a plan is one of `plan_contact_cases`.
bool is_contact_case(const CasePlan& plan);

/// The law that a plan hides; none: nothing.
std::optional<ContactLaw> hidden_law(const CasePlan& plan);

/// Makes a case and writes what a user would have of it into `folder`: `rig.toml`, a CSV file for each trial and, of a
/// robot that no plugin has, `robot.toml`. Throws where the plan cannot be carried out.
MadeContactCase make_contact_case(const CasePlan& plan, const std::filesystem::path& folder);

}  // namespace hidden_effects
