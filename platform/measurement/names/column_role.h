#pragma once

namespace lacuna {

/// What a column may be for an experiment.
enum class ColumnRole {
  time,
  trial,      ///< tells trials apart
  position,   ///< of a joint
  velocity,   ///< of a joint
  command,    ///< what an actuator is given
  reference,  ///< what the rig should do; a servo's command
  other       ///< not needed, or not understood
};

}  // namespace lacuna
