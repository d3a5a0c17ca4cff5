#pragma once

#include "app/workspace/rig_draft.h"

#include <filesystem>
#include <string>

namespace lacuna {

/// Prints the guesses of a draft: the clock, a table of joints with their columns, unused columns, and the
/// recordings.
void print_guesses(const RigDraft& draft);

/// Prints the lines of a file's text that have blanks, as places to go to.
void print_blanks(const std::filesystem::path& file, const std::string& text);

}  // namespace lacuna
