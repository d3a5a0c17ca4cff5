#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "measurement/names/column_role.h"

namespace lacuna {

/// The words of a column's name without its unit, in lower case and without accents: `ElbowAngle_deg` → elbow, angle;
/// `q1` → q, 1; `Sollwinkel` → soll, winkel; `set point` → setpoint.
std::vector<std::string> words_of(std::string_view name);

/// The role that words of robotics give a column, and how sure they are: what is wanted outweighs the quantity that is
/// wanted, a derivative outweighs its coordinate, a word outweighs a letter. `other`: the words say that it is none of
/// those. Nothing where they say nothing.
std::optional<ColumnRole> role_in_words(const std::vector<std::string>& words);

/// Whether the words say that something is measured, not commanded.
bool tell_measured(const std::vector<std::string>& words);
/// Whether they say that something is wanted or was sent, not read.
bool tell_wanted(const std::vector<std::string>& words);
/// Whether a whole word, not just a letter, names a position or a velocity.
bool name_a_quantity(const std::vector<std::string>& words);
/// Whether they speak of a velocity, of a torque or a force, or of a voltage.
bool tell_velocity(const std::vector<std::string>& words);
bool tell_effort(const std::vector<std::string>& words);
bool tell_voltage(const std::vector<std::string>& words);

/// The last number among words; nothing: there is none.
std::optional<int> number_in(const std::vector<std::string>& words);

/// The words that say nothing about the role, joined: what tells joints apart.
std::string joint_in_words(const std::vector<std::string>& words);

}  // namespace lacuna
