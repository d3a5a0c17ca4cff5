#include "loading/effect_probe.h"

#include "foundation/plugin_call.h"
#include "foundation/process_watch.h"
#include "loading/allocation_count.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace lacuna {
namespace {

constexpr double kStep = 1e-3;          // s
constexpr int kLargestState = 1 << 20;  // doubles; the host refuses far larger ones

/// Numbers with others before and behind them, which a sound effect neither reads nor writes.
template <class Number>
class Guarded {
 public:
  Guarded(std::vector<Number> numbers, Number guard) : size_(numbers.size()), guard_(guard) {
    all_.assign(2 * kGuards + size_, guard);
    std::copy(numbers.begin(), numbers.end(), all_.begin() + kGuards);
  }
  std::span<Number> numbers() { return std::span(all_).subspan(kGuards, size_); }
  bool is_intact() const {
    const auto is_guard = [this](Number number) { return number == guard_; };
    return std::all_of(all_.begin(), all_.begin() + kGuards, is_guard) &&
           std::all_of(all_.end() - kGuards, all_.end(), is_guard);
  }

 private:
  static constexpr std::ptrdiff_t kGuards = 32;
  std::size_t size_;
  Number guard_;
  std::vector<Number> all_;
};

RobotSpec two_links() {
  RobotSpec robot;
  robot.name = "two_links";
  robot.contact.ground = true;
  for (const char* const name : {"upper", "lower"}) {
    BodySpec& body = robot.bodies.emplace_back();
    body.name = name;
    body.com = {0.0, 0.0, -0.2};
    JointSpec& joint = robot.joints.emplace_back();
    joint.name = name;
    joint.child = name;
    ActuatorSpec& actuator = robot.actuators.emplace_back();
    actuator.name = name;
    actuator.joint = name;
    SensorSpec& sensor = robot.sensors.emplace_back();
    sensor.name = name;
    sensor.element = name;
  }
  robot.joints[1].parent = "upper";
  return robot;
}

/// The robot in motion.
struct Moment {
  std::array<double, 2> positions{0.3, -0.2}, velocities{0.7, -1.1}, forces{0.4, 0.1};
  std::array<int, 2> coordinates{0, 1};
  std::array<Eigen::Vector3d, 2> body_positions{Eigen::Vector3d(0.1, 0.0, 0.8), Eigen::Vector3d(0.2, 0.0, 0.5)};
  std::array<Eigen::Vector3d, 2> body_velocities{Eigen::Vector3d(0.3, 0.1, -0.2), Eigen::Vector3d(0.5, -0.1, 0.4)};
  std::array<Eigen::Quaterniond, 2> orientations{Eigen::Quaterniond::Identity(), Eigen::Quaterniond::Identity()};
  std::array<Eigen::Vector3d, 2> spins{Eigen::Vector3d(0.0, 0.7, 0.0), Eigen::Vector3d(0.0, -0.4, 0.1)};

  StepView view() const {
    return {0.25,        positions,      velocities,      forces,       coordinates, coordinates,
            coordinates, body_positions, body_velocities, orientations, spins};
  }
};

/// A value that is not the neutral one, within bounds.
double value_of(const ParameterDeclaration& parameter) {
  const double up = parameter.upper - parameter.default_value, down = parameter.default_value - parameter.lower;
  return parameter.default_value + (up > 0.0 ? 0.5 * std::min(1.0, up) : -0.5 * std::min(1.0, down));
}

std::vector<double> numbers_of(const RobotSpec& robot) {
  std::vector<double> numbers;
  const auto put = [&numbers](std::initializer_list<double> more) { numbers.insert(numbers.end(), more); };
  for (const BodySpec& body : robot.bodies) {
    put({body.mass, body.com.x(), body.com.y(), body.com.z()});
    put({body.inertia.xx, body.inertia.yy, body.inertia.zz, body.inertia.xy, body.inertia.xz, body.inertia.yz});
  }
  for (const JointSpec& joint : robot.joints)
    put({joint.lower, joint.upper, joint.damping, joint.dry_friction, joint.stiffness, joint.rest, joint.armature,
         joint.force});
  for (const ActuatorSpec& actuator : robot.actuators) {
    put({actuator.gain, actuator.offset, actuator.delay, actuator.kp, actuator.ki, actuator.kd, actuator.force_limit,
         actuator.command_lower, actuator.command_upper, actuator.supply_sag});
    const TransmissionSpec& gear = actuator.transmission;
    put({gear.ratio, gear.rotor_inertia, gear.stiffness, gear.damping, gear.gap});
  }
  for (const SensorSpec& sensor : robot.sensors)
    put({sensor.delay, sensor.scale, sensor.offset, sensor.noise, sensor.quantum});
  const ContactSpec& contact = robot.contact;
  put({contact.stiffness, contact.damping, contact.friction, contact.slope, contact.impact_damping, contact.restitution,
       contact.rolling_lever, contact.creep});
  put({robot.gravity.x(), robot.gravity.y(), robot.gravity.z()});
  return numbers;
}

/// What acts on the robot, in memory of its own.
struct Loads {
  std::array<JointLoad, 2> joints;
  std::array<BodyLoad, 2> bodies;
  ContactSpec contact;
  Eigen::Vector3d gravity{0.0, 0.0, -9.81};

  StepLoads view() { return {joints, bodies, contact, gravity}; }

  std::vector<double> summands() const {
    std::vector<double> numbers;
    for (const JointLoad& load : joints)
      numbers.insert(numbers.end(),
                     {load.force, load.friction_lower, load.friction_upper, load.damping, load.stiffness});
    for (const BodyLoad& load : bodies) {
      numbers.insert(numbers.end(), load.force.begin(), load.force.end());
      numbers.insert(numbers.end(), load.torque.begin(), load.torque.end());
      numbers.insert(numbers.end(), {load.damping, load.angular_damping});
    }
    return numbers;
  }
};

/// As other effects leave them.
Loads loads_of_others() {
  Loads loads;
  for (JointLoad& load : loads.joints) load = {7.3, -5.1, 4.3, 3.3, 2.9};
  for (BodyLoad& load : loads.bodies) load = {{1.3, 2.7, -3.1}, {0.7, -1.9, 2.3}, 1.7, 0.9};
  return loads;
}

/// What one go through the hooks gave.
struct Course {
  std::vector<std::pair<const char*, std::vector<double>>> results;  ///< by call
  std::vector<double> summands;                                      ///< of the loads
  bool replaced_loads = false;
  bool kept_to_state = true;
  bool threw = false;
  std::vector<std::pair<const char*, long>> allocations;  ///< by call, none left out that is called in a step
};

/// How a go differs from another.
struct Conditions {
  double guard = 0.37;
  bool has_others = false;  ///< whether other effects have added loads before
  bool looks_at_process = false;
};

/// An effect at one place.
class PlacedTrial {
 public:
  PlacedTrial(const PhysicalEffect& effect, const EffectDescription& description, ElementKind kind,
              std::vector<int> elements)
      : effect_(effect), kind_(kind), elements_(std::move(elements)) {
    for (const ParameterDeclaration& parameter : description.parameters) values_.push_back(value_of(parameter));
  }

  Course go(const Conditions& conditions) const {
    Course course;
    try {
      call_hooks(conditions, course);
    } catch (const ProcessChanged&) {
      throw;
    } catch (...) {
      course.threw = true;
    }
    return course;
  }

 private:
  /// How much the call allocated.
  template <class Call>
  static long call(const Conditions& conditions, const char* what, Call&& hook) {
    long allocated = 0;
    {
      const PluginCall active(own_call_slot().component, what);
      const long before = allocations_of_this_thread();
      std::forward<Call>(hook)();
      allocated = allocations_of_this_thread() - before;
    }
    if (conditions.looks_at_process) throw_if_process_changed(what);
    return allocated;
  }

  /// A hook that is called in a step: the second time it has what it needs.
  template <class Call>
  static void call_in_step(const Conditions& conditions, const char* what, Course& course, Call&& hook) {
    call(conditions, what, hook);
    course.allocations.emplace_back(what, call(conditions, what, hook));
  }

  void call_hooks(const Conditions& conditions, Course& course) const {
    const OverriddenHooks& hooks = effect_.overridden();
    Guarded<double> parameters(values_, conditions.guard);
    Guarded<int> elements(elements_, 0);
    const EffectContext context{parameters.numbers(), elements.numbers(), kind_, kStep};
    RobotSpec robot = two_links();
    if (hooks.amend) call(conditions, "amend", [&] { effect_.amend(robot, context); });
    course.results.emplace_back("amend", numbers_of(robot));
    int size = 0;
    call(conditions, "state_size", [&] { size = effect_.state_size(context); });
    course.results.emplace_back("state_size", std::vector<double>{static_cast<double>(size)});
    if (size < 0 || size > kLargestState) return;
    Guarded<double> state(std::vector<double>(static_cast<std::size_t>(size), 0.0), 0.37);
    take_step(conditions, context, state.numbers(), course);
    course.kept_to_state = state.is_intact();
  }

  void take_step(const Conditions& conditions, const EffectContext& context, std::span<double> state,
                 Course& course) const {
    const OverriddenHooks& hooks = effect_.overridden();
    const Moment moment;
    const StepView view = moment.view();
    call(conditions, "start", [&] { effect_.start(view, context, state); });
    course.results.emplace_back("start", std::vector<double>(state.begin(), state.end()));
    if (hooks.command && kind_ == ElementKind::actuator) {
      double value = 0.0;
      call_in_step(conditions, "command", course, [&] { value = effect_.command(0.8, 0, view, context, state); });
      course.results.emplace_back("command", std::vector<double>{value});
    }
    if (hooks.add_loads) add_loads(conditions, view, context, state, course);
    if (hooks.advance) {
      call_in_step(conditions, "advance", course, [&] { effect_.advance(view, context, state); });
      course.results.emplace_back("advance", std::vector<double>(state.begin(), state.end()));
    }
    if (hooks.sense && kind_ == ElementKind::sensor) {
      std::array<double, 1> channels{0.6};
      call_in_step(conditions, "sense", course, [&] { effect_.sense(channels, 0, view, context, state); });
      course.results.emplace_back("sense", std::vector<double>(channels.begin(), channels.end()));
    }
  }

  void add_loads(const Conditions& conditions, const StepView& view, const EffectContext& context,
                 std::span<const double> state, Course& course) const {
    Loads loads;
    call_in_step(conditions, "add_loads", course, [&] {
      loads = conditions.has_others ? loads_of_others() : Loads{};
      StepLoads given = loads.view();
      effect_.add_loads(view, context, state, given);
      if (given.joints.data() != loads.joints.data() || given.joints.size() != loads.joints.size() ||
          given.bodies.data() != loads.bodies.data() || given.bodies.size() != loads.bodies.size())
        course.replaced_loads = true;
    });
    course.summands = loads.summands();
    std::vector<double> all = course.summands;
    const ContactSpec& contact = loads.contact;
    all.insert(all.end(), {contact.stiffness, contact.damping, contact.friction, contact.slope, loads.gravity.x(),
                           loads.gravity.y(), loads.gravity.z()});
    course.results.emplace_back("add_loads", std::move(all));
  }

  const PhysicalEffect& effect_;
  ElementKind kind_;
  std::vector<int> elements_;
  std::vector<double> values_;
};

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

/// The first call that gave something else; null: none.
const char* first_difference(const Course& a, const Course& b) {
  for (std::size_t i = 0; i < std::min(a.results.size(), b.results.size()); ++i) {
    const std::vector<double>& ours = a.results[i].second;
    const std::vector<double>& theirs = b.results[i].second;
    if (!std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end(), same_bits)) return a.results[i].first;
  }
  if (a.results.size() == b.results.size() && a.threw == b.threw) return nullptr;
  const Course& longer = a.results.size() > b.results.size() ? a : b;
  return longer.results.back().first;
}

std::string reading_problem(const PlacedTrial& trial, const Course& first, std::size_t parameters) {
  if (first_difference(first, trial.go({})) != nullptr) return {};  // not the same twice: nothing follows from it
  constexpr double kOtherGuard = -1906.5;
  const char* const call = first_difference(first, trial.go({.guard = kOtherGuard}));
  return call == nullptr ? ""
                         : fmt::format(
                               "{} reads beyond its parameters, of which there are {}: what it gives depends on "
                               "what lies in memory beside them",
                               call, parameters);
}

/// Where others have added loads, the sum is another one, unless it was overwritten.
std::string overwriting_problem(const PlacedTrial& trial, const Course& alone) {
  constexpr double kLarge = 1e9;  // in which what others have added may vanish
  const Course beside = trial.go({.has_others = true});
  const std::vector<double> others = loads_of_others().summands();
  if (beside.threw || beside.summands.size() != alone.summands.size()) return {};
  for (std::size_t i = 0; i < alone.summands.size(); ++i)
    if (others[i] != 0.0 && std::abs(alone.summands[i]) < kLarge && same_bits(alone.summands[i], beside.summands[i]))
      return "add_loads overwrites loads that other effects have added; add to them (+=)";
  return {};
}

std::string allocation_remark(const Course& course) {
  for (const auto& [call, count] : course.allocations)
    if (count > 0)
      return fmt::format(
          "{} allocates memory ({} a call), which an effect must not in a step: each model that has it is slower; keep "
          "what it needs in its state, or in arrays of fixed size",
          call, count == 1 ? "once" : fmt::format("{} times", count));
  return {};
}

EffectFindings findings_at(const PlacedTrial& trial, std::size_t parameters, const Course& course) {
  if (course.replaced_loads) return {"add_loads replaces the list of loads; add to its elements", {}};
  if (!course.kept_to_state) return {"it writes beyond its state; let `state_size` tell how many numbers it needs", {}};
  for (const std::string& problem :
       {reading_problem(trial, course, parameters), course.threw ? std::string() : overwriting_problem(trial, course)})
    if (!problem.empty()) return {problem, {}};
  return {{}, allocation_remark(course)};
}

}  // namespace

EffectFindings try_effect(const PhysicalEffect& effect, const EffectDescription& description) {
  count_allocations();
  EffectFindings findings;
  for (const ElementKind kind : description.placements)
    for (std::vector<int> elements : {std::vector<int>{0}, std::vector<int>{0, 1}}) {
      if (kind == ElementKind::world) elements.clear();
      const PlacedTrial trial(effect, description, kind, elements);
      const Course course = trial.go({.looks_at_process = true});
      if (course.threw && elements.size() == 1) continue;  // some act between two elements
      const EffectFindings here = findings_at(trial, description.parameters.size(), course);
      if (!here.problem.empty()) return here;
      if (findings.remark.empty()) findings.remark = here.remark;
      break;
    }
  return findings;
}

}  // namespace lacuna
