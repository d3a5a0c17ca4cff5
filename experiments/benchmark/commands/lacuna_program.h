#pragma once

#include "runs/user_session.h"

#include <filesystem>
#include <string>

namespace hidden_effects {

/// The program that is measured, by default the one beside this one, where a build puts both. Throws
/// `std::invalid_argument` where there is none. `longest`: s, of one call.
ProgramSettings program_settings(const std::filesystem::path& lacuna, int longest);

/// What it says of itself and which file it is: another build may give other results. Throws `std::invalid_argument`
/// where it is another program.
std::string identity_of(const ProgramSettings& settings, const std::filesystem::path& folder);

}  // namespace hidden_effects
