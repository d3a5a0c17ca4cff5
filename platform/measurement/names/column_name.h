#pragma once

#include <string>
#include <string_view>

namespace lacuna {

/// A unit as written in tables, in the notation of foundation/unit.h: `[Nm]` → `N*m`, `m/s²` → `m/s^2`, `sec` → `s`,
/// `°` → `deg`. Empty if it is not a unit.
std::string unit_of_cell(std::string_view cell);

/// The unit in a column's name, `angle [deg]`, `torque (Nm) filtered`, `theta_rad`, `theta_dot_rad_s`, `acc_m_s2`,
/// `Motorstrom in A`, `x/m`, `angle, deg`, `angleDeg`; empty if there is none. Outside of brackets only unmistakable
/// symbols count: `joint_min` and `x_1` have no unit.
std::string unit_in_name(std::string_view name);

/// The name without its unit: `theta_dot` for `theta_dot_rad_s`.
std::string name_without_unit(std::string_view name);

}  // namespace lacuna
