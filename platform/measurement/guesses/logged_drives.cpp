#include "measurement/guesses/logged_drives.h"

#include "foundation/unit.h"

#include <algorithm>

namespace lacuna {
namespace {

struct Logged {
  bool efforts = false, positions = false, velocities = false;
};

Logged logged_in(const std::vector<GuessedColumn>& columns) {
  Logged logged;
  for (const GuessedColumn& column : columns) {
    if (column.passed_over) continue;
    logged.efforts = logged.efforts || column.role == ColumnRole::command;
    if (column.role != ColumnRole::reference) continue;
    const std::optional<Unit> unit = parse_unit(column.unit);
    const bool is_rate = column.unit.empty() || !unit
                             ? column.of_velocity
                             : unit->same_dimension(*parse_unit("rad/s")) || unit->same_dimension(*parse_unit("m/s"));
    (is_rate ? logged.velocities : logged.positions) = true;
  }
  return logged;
}

}  // namespace

std::optional<ActuatorKind> logged_drive(const FileSample& sample, const ColumnHints& hints, const RobotSpec& robot) {
  if (robot.actuators.empty()) return std::nullopt;
  const ActuatorKind kind = robot.actuators.front().kind;
  if (std::ranges::any_of(robot.actuators, [&](const ActuatorSpec& one) { return one.kind != kind; }))
    return std::nullopt;
  const Logged logged = logged_in(guess_columns(sample, hints));
  const bool is_servo = kind == ActuatorKind::position_servo || kind == ActuatorKind::velocity_servo;
  if (is_servo && logged.efforts && !logged.positions && !logged.velocities) return ActuatorKind::force;
  if (kind != ActuatorKind::force || logged.efforts) return std::nullopt;
  if (logged.positions) return ActuatorKind::position_servo;
  return logged.velocities ? std::optional(ActuatorKind::velocity_servo) : std::nullopt;
}

}  // namespace lacuna
