#pragma once

namespace lacuna {

/// The possible roles of a column in an experiment.
enum class ColumnRole {
  time,
  trial,      ///< tells trials apart
  position,   ///< of a joint
  velocity,   ///< of a joint
  command,    ///< command of an actuator
  reference,  ///< setpoint of the rig; a servo's command
  other       ///< not needed, or not understood
};

}  // namespace lacuna
