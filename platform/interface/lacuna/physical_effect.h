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
/// noise and quantum after all of them. `quantisation` of a command stands first among what changes values: a
/// controller sends whole steps, and what is analogue comes behind it.
enum class CommandStage { none, delay, quantisation, gain, offset, lag, slew_rate, dead_zone, saturation };
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
  bool add_loads = true;
  bool advance = true;
  bool command = true;
  bool sense = true;
};

/// What the engine calls of an effect.
struct EffectHooks {
  bool amends_robot = false;
  bool add_loads = false;
  bool advance = false;
  CommandStage command = CommandStage::none;
  SensorStage sensor = SensorStage::none;
};

/// One placed effect, as its hooks see it. Valid during the call only.
struct EffectContext {
  std::span<const double> parameters;  ///< in the order of `EffectDescription::parameters`, SI
  std::span<const int> elements;       ///< indices into the spec's list of the placement's kind; empty for the world
  ElementKind kind = ElementKind::world;
  double step = 0.0;  ///< length of the step that the call is about, s; in `state_size` of a whole one
};

/// The mechanical state at one moment. Coordinates are counted over joints in their order (hinge, slider 1; universal
/// 2; ball 3; fixed 0): `first_coordinate[joint]`.
struct StepView {
  double time = 0.0;                                 ///< s
  std::span<const double> positions;                 ///< joint coordinates, rad or m
  std::span<const double> velocities;                ///< rad/s or m/s
  std::span<const double> actuator_forces;           ///< per actuator, joint side, N·m or N; of a servo, an estimate
  std::span<const int> first_coordinate;             ///< per joint
  std::span<const int> actuator_coordinate;          ///< per actuator, the coordinate that it drives
  std::span<const int> sensor_coordinate;            ///< per sensor, the first of the joint that it reads; −1: none
  std::span<const Eigen::Vector3d> body_positions;   ///< centres of mass, world, m
  std::span<const Eigen::Vector3d> body_velocities;  ///< of the centres of mass, world, m/s
  std::span<const Eigen::Quaterniond> body_orientations;     ///< body to world
  std::span<const Eigen::Vector3d> body_angular_velocities;  ///< world, rad/s
};

/// Laws on one joint coordinate for the coming step; add to them, never overwrite. `force` is the force at the view's
/// position and velocity. The slopes say by how much less it becomes per unit of velocity and of position beyond the
/// view's; the engine follows the force with them to the velocities that the step has, implicitly, so that steep laws
/// stay stable. A law whose slope is left out, or estimated, keeps the engine's order.
struct JointLoad {
  double force = 0.0;           ///< N·m or N
  double friction_lower = 0.0;  ///< dry friction may exert at least this ... (≤ 0)
  double friction_upper = 0.0;  ///< ... and at most this (≥ 0), whatever holds the velocity at zero
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

/// Force on a body's centre of mass and torque for the coming step, world frame, at the view's velocities; and slopes
/// as those of a joint, alike in all directions.
struct BodyLoad {
  Eigen::Vector3d force{0.0, 0.0, 0.0};   ///< N
  Eigen::Vector3d torque{0.0, 0.0, 0.0};  ///< N·m
  double damping = 0.0;                   ///< of the force, by the velocity of the centre of mass, N·s/m, ≥ 0
  double angular_damping = 0.0;           ///< of the torque, by the angular velocity, N·m·s/rad, ≥ 0
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
/// The hooks are `amend`, `add_loads`, `advance`, `command` and `sense`. An effect overrides those that it needs,
/// in public; the host calls what is overridden.
///
/// `command` and `sense` are called once a step of whole length, at its start and at its end. `add_loads` and `advance`
/// are about a step of length `context.step`, which may be a part of such a one: the engine cuts a step where a joint
/// comes to rest or meets a stop. `engine = "articulated"` asks for loads in the middle of the step, several times, the
/// last time at the step's mean velocities, and needs them there to second order: with a memory, its mean over the
/// step. `engine = "ode"` asks once, at the start of the step, and uses the slopes up to its end.
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
  /// Adds what acts in the step. `state` is that at its start.
  virtual void add_loads(const StepView&, const EffectContext&, std::span<const double> /*state*/, StepLoads&) const {}
  /// Moves the state through a step that was taken. `view` has the configuration at which loads were asked for, and the
  /// joints' mean velocities over the step.
  virtual void advance(const StepView&, const EffectContext&, std::span<double> /*state*/) const {}
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
  /// By how much later than the motion the readings of its sensors are at `time`, both s, negative where they are
  /// earlier; a delay that `amend` writes into
  /// the robot is not part of it. For effects that override `sense`: where a motion is begun that readings tell, it is
  /// begun so much later.
  virtual double lateness(double /*time*/, const EffectContext&) const { return 0.0; }

  /// What the host calls of it.
  EffectHooks hooks() const {
    const EffectStages stages_of = stages();
    return {overridden_.amend, overridden_.add_loads, overridden_.advance, stages_of.command, stages_of.sensor};
  }
  const OverriddenHooks& overridden() const { return overridden_; }
  /// The factory that `component` makes says what it found out; of an object that was made otherwise, as in a test, all
  /// hooks are called.
  void set_overridden(const OverriddenHooks& hooks) { overridden_ = hooks; }

 private:
  OverriddenHooks overridden_;
};

}  // namespace lacuna
