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

/// The role of a column from words of robotics, and how sure it is: a setpoint outweighs its quantity, a derivative
/// outweighs its coordinate, a word outweighs a letter. `other`: the words name another quantity. Nothing where the
/// words are unknown.
std::optional<ColumnRole> role_in_words(const std::vector<std::string>& words);

/// Whether the words mean a measurement, not a command.
bool tell_measured(const std::vector<std::string>& words);
/// Whether the words mean a setpoint or a command, not a reading.
bool tell_wanted(const std::vector<std::string>& words);
/// Whether a whole word, not only a letter, names a position or a velocity.
bool name_a_quantity(const std::vector<std::string>& words);
/// Whether they mean a velocity, a torque or a force, or a voltage.
bool tell_velocity(const std::vector<std::string>& words);
bool tell_effort(const std::vector<std::string>& words);
bool tell_voltage(const std::vector<std::string>& words);

/// The last number among words; nothing: there is none.
std::optional<int> number_in(const std::vector<std::string>& words);

/// The words without meaning for the role, joined: they distinguish joints.
std::string joint_in_words(const std::vector<std::string>& words);

}  // namespace lacuna
