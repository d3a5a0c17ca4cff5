#pragma once

#include "plant/chain.h"
#include "plant/plant_spec.h"

#include <vector>

namespace hidden_effects {

/// What a law sees: the middle of an integration step.
struct Moment {
  double time = 0.0;            ///< s, in the middle of the step
  double step = 0.0;            ///< s
  const Coordinates& position;  ///< of the joints, then of elastic rotors
  const Coordinates& velocity;  ///< as foreseen
  const Coordinates& drive;     ///< what each joint's drives exert on it, N·m or N
  const PlantSpec& spec;
  const Chain& chain;
};

/// What acts on the coordinates in a step. The brakes are dry: at most so much against motion in either direction.
struct Load {
  Coordinates force;
  Coordinates brake_forwards, brake_backwards;  ///< both ≥ 0
};

/// Readings of one channel, evenly spaced, from the start of the trial on.
struct DenseReadings {
  std::vector<double> values;
  double interval = 0.0;  ///< s
};

/// A physical law that a plant obeys beyond its rigid bodies. A law is immutable and may be shared; what it remembers
/// of a trial stands in the `memory` that it is handed, `memory_size` numbers, zero at the start unless `start` says
/// otherwise. Each hook is optional. Laws are written down from the literature, not from the library that is tested.
class Law {
 public:
  virtual ~Law() = default;

  /// Changes the plant's own data before anything moves.
  virtual void amend(PlantSpec&) const {}

  virtual int memory_size() const { return 0; }
  virtual void start(const Coordinates& /*position*/, const Coordinates& /*velocity*/, double* /*memory*/) const {}

  /// s, by which a command is late beyond the drive's own delay, at a time in s.
  virtual double lateness(int /*drive*/, double /*time*/) const { return 0.0; }

  /// A command on its way to drive `drive`: its mean over the step.
  virtual double command(int /*drive*/, double value, const Moment&, double* /*memory*/) const { return value; }

  /// Adds forces and brakes; called once a step.
  virtual void act(const Moment&, double* /*memory*/, Load&) const {}

  /// Changes what sensor `sensor` says.
  virtual void read(int /*sensor*/, DenseReadings&) const {}
};

}  // namespace hidden_effects
