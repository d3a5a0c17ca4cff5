#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "measurement/column_guess.h"

namespace lacuna {

/// The words of a column's name without its unit, in lower case: `ElbowAngle_deg` → elbow, angle; `q1` → q, 1.
std::vector<std::string> words_of(std::string_view name);

/// The role that words of robotics give a column, and how sure they are: a reference word outweighs what is
/// referred to, a derivative outweighs its coordinate.
std::optional<ColumnRole> role_in_words(const std::vector<std::string>& words);

/// The words that say nothing about the role, joined: what tells joints apart.
std::string joint_in_words(const std::vector<std::string>& words);

}  // namespace lacuna
