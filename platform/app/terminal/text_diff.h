#pragma once

#include <string>

namespace lacuna {

/// The lines in which two versions of a file differ, with two lines around them, marked `-` and
/// `+` and numbered. One block: what lies between the first and the last difference is shown whole.
std::string text_diff(const std::string& before, const std::string& after);

}  // namespace lacuna
