#pragma once

#include "contacts/contact_case.h"

namespace hidden_effects {

/// `robot.toml` of a rig that no robot plugin has. Makes the folder.
void write_contact_robot(const ContactRig& rig, const std::filesystem::path& folder);

/// `rig.toml` with these laws in the model, and the recordings.
void write_contact_case(const MadeContactCase& made, const std::filesystem::path& folder,
                        const std::vector<SizedContactLaw>& laws = {});

}  // namespace hidden_effects
