#pragma once

#include <lacuna/robot_spec.h>

#include <string>
#include <utility>
#include <vector>

namespace lacuna {

/// A robot file (`schema/robot.md`) of a robot, with `comment` at its head: what the defaults do not say. Read back it
/// has the same numbers, but for those that a robot file has no key for (of contacts, what effects alone change) and
/// the last digit of turns.
std::string robot_toml(const RobotSpec& robot, const std::string& comment);

/// An inertia as a TOML table: `{ xx = 0.1, yy = ... }`.
std::string inertia_toml(const InertiaSpec& inertia);

/// The text of a robot file with other numbers at the addresses, everything else byte for byte as it was: a number that
/// is written is replaced, one that is not becomes a key of its section. Of a centre of mass or an inertia that is not
/// written all components of `robot` are. Throws `Error` where the text cannot be edited in its layout.
std::string with_robot_values(const std::string& text, const RobotSpec& robot,
                              const std::vector<std::pair<std::string, double>>& values);

}  // namespace lacuna
