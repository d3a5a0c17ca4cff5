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

/// The description of an effect for users, and for the host's check of its use.
struct EffectDescription {
  std::string summary;                   ///< one sentence
  std::string equation;                  ///< as in "tau = -b*v"
  std::string literature;                ///< source of the equation
  std::string regime;                    ///< motion in which it shows
  std::vector<std::string> look_alikes;  ///< names of effects that are hard to distinguish from it
  std::vector<ElementKind> placements;   ///< kinds of elements on which it can be placed
  ParameterDeclarations parameters;
  /// Values of the parameters at which it changes nothing, where those are not the defaults. Where a value is not zero
  /// but a bound, such as a stiffness, the effect decreases towards the bound.
  std::vector<double> neutral = {};
  /// It removes mechanical energy from the robot; springs in it only return energy that they stored before.
  bool dissipative = false;
};

/// Command and sensor effects run in the order of these stages, independent of the order of the effect list; within a
/// stage, in the order of effect name, then placement. An actuator's own delay, gain and offset, and a sensor's own
/// delay, come before all of them (effects that only change these values need no hook); an actuator's limits and a
/// sensor's own scale, offset, noise and quantum come after all of them. `quantisation` is the first of the stages that
/// change the value of a command: a controller sends whole steps, and analogue parts follow it.
enum class CommandStage { none, delay, quantisation, gain, offset, lag, slew_rate, dead_zone, saturation };
enum class SensorStage { none, delay, lag, geometry, scale, offset, drift, saturation, quantisation };

/// The stages in which an effect acts on commands and readings. An effect that overrides `command` or `sense` names the
/// stage; the host refuses an effect that overrides without a stage, or names a stage without overriding.
struct EffectStages {
  CommandStage command = CommandStage::none;
  SensorStage sensor = SensorStage::none;
};

/// The hooks that a class overrides (lacuna/overridden_hooks.h determines them); the others cost nothing in a step.
struct OverriddenHooks {
  bool amend = true;
  bool add_loads = true;
  bool advance = true;
  bool command = true;
  bool sense = true;
};

/// The parts of an effect that the engine uses.
struct EffectHooks {
  bool amends_robot = false;
  bool add_loads = false;
  bool advance = false;
  CommandStage command = CommandStage::none;
  SensorStage sensor = SensorStage::none;
};

/// One placed effect, as passed to its hooks. Valid during the call only.
struct EffectContext {
  std::span<const double> parameters;  ///< in the order of `EffectDescription::parameters`, SI
  std::span<const int> elements;       ///< indices into the spec's list of the placement's kind; empty for the world
  ElementKind kind = ElementKind::world;
  double step = 0.0;  ///< length of the current step, s; in `state_size` of a whole one
};

/// The mechanical state at one moment. Coordinates are counted over joints in their order (hinge, slider 1; universal
/// 2; ball 3; fixed 0): `first_coordinate[joint]`.
struct StepView {
  double time = 0.0;                         ///< s
  std::span<const double> positions;         ///< joint coordinates, rad or m
  std::span<const double> velocities;        ///< rad/s or m/s
  std::span<const double> actuator_forces;   ///< per actuator, joint side, N·m or N; of a servo, an estimate
  std::span<const int> first_coordinate;     ///< per joint
  std::span<const int> actuator_coordinate;  ///< per actuator, the coordinate that it drives
  std::span<const int> sensor_coordinate;  ///< per sensor, the first coordinate of the joint that it reads; −1: none
  std::span<const Eigen::Vector3d> body_positions;           ///< centres of mass, world, m
  std::span<const Eigen::Vector3d> body_velocities;          ///< of the centres of mass, world, m/s
  std::span<const Eigen::Quaterniond> body_orientations;     ///< body to world
  std::span<const Eigen::Vector3d> body_angular_velocities;  ///< world, rad/s
};

/// Laws on one joint coordinate for the coming step; add to them, never overwrite. `force` is the force at the view's
/// position and velocity. The slopes are its decrease per unit of velocity and of position from the view's values; with
/// them the engine extrapolates the force implicitly to the velocities at the end of the step, so that steep laws stay
/// stable. A law whose slope is left out, or estimated, keeps the engine's order of convergence.
struct JointLoad {
  double force = 0.0;           ///< N·m or N
  double friction_lower = 0.0;  ///< lower limit of the dry friction force (≤ 0) ...
  double friction_upper = 0.0;  ///< ... and its upper limit (≥ 0); within them it holds the velocity at zero
  double damping = 0.0;         ///< −∂force/∂velocity, ≥ 0
  double stiffness = 0.0;       ///< −∂force/∂position, ≥ 0

  void add_friction(double limit) {
    friction_lower -= limit;
    friction_upper += limit;
  }
  /// The force −b·v.
  void add_damping(double b, double v) {
    force -= b * v;
    damping += b;
  }
  /// The force −k·stretch.
  void add_spring(double k, double stretch) {
    force -= k * stretch;
    stiffness += k;
  }
};

/// Force on a body's centre of mass and torque for the coming step, world frame, at the view's velocities; with slopes
/// like those of a joint, isotropic.
struct BodyLoad {
  Eigen::Vector3d force{0.0, 0.0, 0.0};   ///< N
  Eigen::Vector3d torque{0.0, 0.0, 0.0};  ///< N·m
  double damping = 0.0;                   ///< of the force, by the velocity of the centre of mass, N·s/m, ≥ 0
  double angular_damping = 0.0;           ///< of the torque, by the angular velocity, N·m·s/rad, ≥ 0
};

struct StepLoads {
  std::span<JointLoad> joints;  ///< one a coordinate
  std::span<BodyLoad> bodies;
  ContactSpec& contact;  ///< each step starts with the robot's value
  Eigen::Vector3d& gravity;
};

/// A physical effect that a model may include. Const and shared by threads: memory between steps must be in `state`,
/// which the host owns, saves and restores. The same arguments give the same results. A hook that is called in a step
/// must not allocate. Hooks may throw `Error`; the evaluation is then invalid.
///
/// The hooks are `amend`, `add_loads`, `advance`, `command` and `sense`. An effect overrides those that it needs, in
/// its public section; the host calls only overridden hooks.
///
/// `command` and `sense` are called once per whole step, at its start and at its end. `add_loads` and `advance` are
/// called for a step of length `context.step`, which may be a part of a whole one: the engine divides a step where a
/// joint comes to rest or meets a stop. `engine = "articulated"` asks for loads in the middle of the step, several
/// times, the last time at the step's mean velocities, and needs them there to second order: for an effect with memory,
/// its mean over the step. `engine = "ode"` asks once, at the start of the step, and uses the slopes up to its end.
class PhysicalEffect {
 public:
  virtual ~PhysicalEffect() = default;

  virtual EffectDescription describe() const = 0;
  /// For effects that override `command` or `sense`.
  virtual EffectStages stages() const { return {}; }

  /// Number of doubles of state for a placement; `context.parameters` holds each parameter's largest value.
  virtual int state_size(const EffectContext&) const { return 0; }
  /// Fills the state for a start at `view`; the state is zero before the call.
  virtual void start(const StepView&, const EffectContext&, std::span<double> /*state*/) const {}

  /// Changes the robot before it is compiled, for the given parameters. It may change values,
  /// not add or remove elements.
  virtual void amend(RobotSpec&, const EffectContext&) const {}
  /// Adds the loads of the step. `state` is the state at its start.
  virtual void add_loads(const StepView&, const EffectContext&, std::span<const double> /*state*/, StepLoads&) const {}
  /// Advances the state over a completed step. `view` has the configuration for which loads were requested, and the
  /// joints' mean velocities over the step.
  virtual void advance(const StepView&, const EffectContext&, std::span<double> /*state*/) const {}
  /// Changes a command for the actuator `context.elements[which]`: gets its mean over the step (command unit) and
  /// returns the changed value. For recorded commands, called once before the first step with the earlier command, so
  /// that a memory in `state` begins with it.
  virtual double command(double value, int /*which*/, const StepView&, const EffectContext&,
                         std::span<double> /*state*/) const {
    return value;
  }
  /// Changes the channels of the sensor `context.elements[which]` in place.
  virtual void sense(std::span<double> /*channels*/, int /*which*/, const StepView&, const EffectContext&,
                     std::span<double> /*state*/) const {}
  /// Delay of the readings of its sensors behind the motion at `time`, both s, negative where readings are early;
  /// without a delay that `amend` writes into the robot. For effects that override `sense`: a simulation that starts
  /// from readings shifts its start by this.
  virtual double lateness(double /*time*/, const EffectContext&) const { return 0.0; }

  /// The hooks that the host calls.
  EffectHooks hooks() const {
    const EffectStages stages_of = stages();
    return {overridden_.amend, overridden_.add_loads, overridden_.advance, stages_of.command, stages_of.sensor};
  }
  const OverriddenHooks& overridden() const { return overridden_; }
  /// Set by the factory that `component` makes. For an object made otherwise, as in a test, all hooks are called.
  void set_overridden(const OverriddenHooks& hooks) { overridden_ = hooks; }

 private:
  OverriddenHooks overridden_;
};

}  // namespace lacuna
