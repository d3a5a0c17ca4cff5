#pragma once

#include <lacuna/parameter.h>
#include <lacuna/robot_spec.h>

#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// The kinds of element that an effect can be placed on.
///
/// Units of an effect's parameters often depend on the element. A declared unit may therefore hold the
/// words below, which the host replaces by the element's own unit wherever a user reads it; for an
/// actuator or a sensor the joint is the one that it drives or reads.
///   {position}  the joint's coordinate: rad, on a slider m
///   {force}     its generalised force: N*m, on a slider N
///   {inertia}   kg*m^2, on a slider kg
///   {command}   the actuator's command
///   {channel}   the sensor's channels
/// `{force}*s/{position}` is N*m*s/rad on a hinge and N*s/m on a slider. One placed effect has one unit
/// for each parameter: a hinge and a slider that would need two take an entry each in the effect list.
enum class ElementKind { joint, body, actuator, sensor, world };

/// What a user reads of an effect, and what the host checks its use against.
struct EffectDescription {
  std::string summary;                   ///< one sentence
  std::string equation;                  ///< as in "tau = -b*v"
  std::string literature;                ///< where the equation is from
  std::string regime;                    ///< the motion that shows it
  std::vector<std::string> look_alikes;  ///< names of effects that are hard to tell from it
  std::vector<ElementKind> placements;   ///< where it can be placed
  ParameterDeclarations parameters;
  /// Values of the parameters at which it changes nothing, where those are not the defaults. If some are not zero but
  /// a bound, as of a stiffness, the effect fades on the way there.
  std::vector<double> neutral = {};
  /// It takes mechanical energy out of the robot; what springs in it store came from there and does not grow.
  bool dissipative = false;
};

/// Command and sensor effects run in the order of these stages, whatever the order of the
/// effect list; within a stage, in the order of effect name, then placement. An actuator's own
/// delay, gain and offset, and a sensor's own delay, come before all of them (effects that only
/// change these values need no hook), an actuator's limits and a sensor's own scale, offset,
/// noise and quantum after all of them.
enum class CommandStage { none, delay, gain, offset, lag, slew_rate, dead_zone, saturation };
enum class SensorStage { none, delay, lag, geometry, scale, offset, drift, saturation, quantisation };

/// Where an effect acts on commands and on readings. One that overrides `command` or `sense` names the stage; the host
/// refuses an effect that overrides without a stage, or names a stage without overriding.
struct EffectStages {
  CommandStage command = CommandStage::none;
  SensorStage sensor = SensorStage::none;
};

/// Which hooks a class overrides (lacuna/overridden_hooks.h finds out); the others cost nothing in a step.
struct OverriddenHooks {
  bool amend = true;
  bool before_step = true;
  bool after_step = true;
  bool command = true;
  bool sense = true;
};

/// What the engine calls of an effect.
struct EffectHooks {
  bool amends_robot = false;
  bool before_step = false;
  bool after_step = false;
  CommandStage command = CommandStage::none;
  SensorStage sensor = SensorStage::none;
};

/// One placed effect, as its hooks see it. Valid during the call only.
struct EffectContext {
  std::span<const double> parameters;  ///< in the order of `EffectDescription::parameters`, SI
  std::span<const int> elements;       ///< indices into the spec's list of the placement's kind; empty for the world
  ElementKind kind = ElementKind::world;
  double step = 0.0;  ///< integration step, s
};

/// The mechanical state at one integration step. Coordinates are counted over joints in
/// their order (hinge, slider 1; universal 2; ball 3; fixed 0): `first_coordinate[joint]`.
struct StepView {
  double time = 0.0;                        ///< s, at the start of the step
  std::span<const double> positions;        ///< joint coordinates, rad or m
  std::span<const double> velocities;       ///< rad/s or m/s
  std::span<const double> actuator_forces;  ///< per actuator, joint side, N·m or N; of a servo, that of the step before
  std::span<const int> first_coordinate;    ///< per joint
  std::span<const int> actuator_coordinate;                  ///< per actuator, the coordinate that it drives
  std::span<const Eigen::Vector3d> body_positions;           ///< centres of mass, world, m
  std::span<const Eigen::Vector3d> body_velocities;          ///< of the centres of mass, world, m/s
  std::span<const Eigen::Quaterniond> body_orientations;     ///< body to world
  std::span<const Eigen::Vector3d> body_angular_velocities;  ///< world, rad/s
};

/// Laws on one joint coordinate for the coming step. The engine integrates dry friction,
/// damping and stiffness implicitly; add to them, never overwrite.
struct JointLoad {
  double force = 0.0;           ///< N·m or N
  double friction_lower = 0.0;  ///< dry friction may exert at least this ... (≤ 0)
  double friction_upper = 0.0;  ///< ... and at most this (≥ 0), whatever holds the velocity at zero
  double damping = 0.0;         ///< ≥ 0
  double stiffness = 0.0;       ///< ≥ 0

  void add_friction(double limit) {
    friction_lower -= limit;
    friction_upper += limit;
  }
};

/// Force on a body's centre of mass and torque for the coming step, world frame.
struct BodyLoad {
  Eigen::Vector3d force{0.0, 0.0, 0.0};   ///< N
  Eigen::Vector3d torque{0.0, 0.0, 0.0};  ///< N·m
};

struct StepLoads {
  std::span<JointLoad> joints;  ///< one a coordinate
  std::span<BodyLoad> bodies;
  ContactSpec& contact;  ///< starts each step as the robot's
  Eigen::Vector3d& gravity;
};

/// A physical effect that a model may include. Const and shared by threads: whatever must be
/// remembered from step to step lies in `state`, which the host owns, saves and restores. The
/// same arguments give the same results. An effect must not allocate in a hook that is called
/// in a step. Hooks may throw `Error`; the evaluation is then invalid.
///
/// The hooks are `amend`, `before_step`, `after_step`, `command` and `sense`. An effect overrides those that it needs,
/// in public; the host calls what is overridden.
class PhysicalEffect {
 public:
  virtual ~PhysicalEffect() = default;

  virtual EffectDescription describe() const = 0;
  /// For effects that override `command` or `sense`.
  virtual EffectStages stages() const { return {}; }

  /// Doubles of state for a placement; `context.parameters` holds each parameter's largest value.
  virtual int state_size(const EffectContext&) const { return 0; }
  /// Fills the state for a start at `view`; it comes zeroed.
  virtual void start(const StepView&, const EffectContext&, std::span<double> /*state*/) const {}

  /// Changes the robot before it is compiled, for the given parameters. It may change values,
  /// not add or remove elements.
  virtual void amend(RobotSpec&, const EffectContext&) const {}
  virtual void before_step(const StepView&, const EffectContext&, std::span<double> /*state*/, StepLoads&) const {}
  /// `view` holds the state that the step has led to.
  virtual void after_step(const StepView&, const EffectContext&, std::span<double> /*state*/) const {}
  /// A command on its way to the actuator `context.elements[which]`: gets its mean over the
  /// step (command unit) and returns what goes on. Recorded commands: called once before the first step with what was
  /// commanded before, so that a memory in `state` begins with that.
  virtual double command(double value, int /*which*/, const StepView&, const EffectContext&,
                         std::span<double> /*state*/) const {
    return value;
  }
  /// Changes the channels of the sensor `context.elements[which]` in place.
  virtual void sense(std::span<double> /*channels*/, int /*which*/, const StepView&, const EffectContext&,
                     std::span<double> /*state*/) const {}

  /// What the host calls of it.
  EffectHooks hooks() const {
    const EffectStages stages_of = stages();
    return {overridden_.amend, overridden_.before_step, overridden_.after_step, stages_of.command, stages_of.sensor};
  }
  const OverriddenHooks& overridden() const { return overridden_; }
  /// The factory that `component` makes says what it found out; of an object that was made otherwise, as in a test, all
  /// hooks are called.
  void set_overridden(const OverriddenHooks& hooks) { overridden_ = hooks; }

 private:
  OverriddenHooks overridden_;
};

}  // namespace lacuna
