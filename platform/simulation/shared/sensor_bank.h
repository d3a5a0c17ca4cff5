#pragma once

#include <lacuna/engine_settings.h>
#include <lacuna/physical_effect.h>
#include <lacuna/time_series.h>

#include "foundation/link_angle.h"
#include "simulation/shared/delay_line.h"
#include "simulation/shared/effect_runner.h"

#include <span>
#include <vector>

namespace lacuna::simulation {

/// Whether sensors of that kind belong to a joint; the others belong to a body.
inline bool reads_joint(SensorKind kind) {
  return kind == SensorKind::joint_position || kind == SensorKind::joint_velocity || kind == SensorKind::joint_force ||
         kind == SensorKind::drive_force || kind == SensorKind::link_angle || kind == SensorKind::link_velocity;
}

/// Input of sensors besides the `StepView`.
struct SensedForces {
  std::span<const double> joint_forces;             ///< per coordinate, of the last step
  std::span<const Eigen::Vector3d> contact_forces;  ///< per body, world, of the last step
  std::span<const unsigned char> touching;          ///< per body
};

/// The sensors of one simulation: true value, delay, effects, scale and offset, once per integration step. Belongs to a
/// workspace; allocates nothing after construction.
class SensorBank {
 public:
  /// `longest`: per sensor, the longest delay of any simulation.
  SensorBank(const RobotSpec& robot, std::span<const Delay> longest);

  /// Takes a simulation's delays, scales and offsets. Throws `Error` for a delay that is longer than declared.
  void configure(const RobotSpec& robot, const EngineSettings& settings);

  /// The first reading: delay lines are filled with it.
  void start(const StepView& view, const SensedForces& forces, EffectRunner& effects);
  void advance(const StepView& view, const SensedForces& forces, EffectRunner& effects);

  /// All channels in spec order, without noise and quantisation.
  std::span<const double> readings() const { return readings_; }
  /// Per sensor, and the number of channels behind the last.
  std::span<const std::size_t> first_channel() const { return first_channel_; }
  bool reads_bodies() const { return reads_bodies_; }
  /// Whether `advance` must see every step, or only those whose readings are needed.
  bool has_memory() const { return has_memory_; }

  void save(StateWriter& writer) const;
  void load(StateReader& reader);
  /// Of everything that `save` writes: readings, contents of delays, memories of accelerometers.
  std::size_t delays_size() const;
  std::size_t last_motions_size() const { return kLastMotion * last_.size(); }

 private:
  static constexpr std::size_t kLastMotion = 4;  ///< numbers
  /// An accelerometer's memory: the velocity of its point in the last step, world, m/s.
  struct LastMotion {
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
    double time = 0.0;  ///< s
  };

  void read(const StepView& view, const SensedForces& forces);
  void remember(const StepView& view);
  Eigen::Vector3d velocity_of_point(std::size_t index, const StepView& view) const;
  Eigen::Vector3d specific_force(std::size_t index, const StepView& view) const;
  void read_one(std::size_t index, const StepView& view, const SensedForces& forces, std::span<double> out) const;
  void refine(const StepView& view, EffectRunner& effects);

  const RobotSpec* robot_ = nullptr;
  std::vector<std::size_t> elements_;         // per sensor: joint or body
  std::vector<std::vector<LinkTurn>> turns_;  // per sensor of a link
  std::vector<std::size_t> first_channel_;    // per sensor, one more
  std::vector<DelayLine> lines_;              // per channel
  std::vector<Delay> delays_;                 // per sensor
  std::vector<double> readings_;              // per channel
  std::vector<LastMotion> last_;              // per sensor; empty: none is an accelerometer
  bool reads_bodies_ = false;
  bool has_memory_ = false;
};

}  // namespace lacuna::simulation
