#include "loading/effect_trial.h"

#include "foundation/plugins/plugin_call.h"
#include "foundation/processes/process_watch.h"
#include "loading/allocation_count.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kStep = 1e-3;          // s
constexpr int kLargestState = 1 << 20;  // doubles; the host refuses far larger ones

/// Numbers with guard values around them, which a valid effect neither reads nor writes.
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

/// The robot in motion: another state in each step, sometimes moving backwards.
struct Moment {
  std::array<double, 2> positions{0.3, -0.2}, velocities{0.7, -1.1}, forces{0.4, 0.1};
  std::array<int, 2> coordinates{0, 1};
  std::array<Eigen::Vector3d, 2> body_positions{Eigen::Vector3d(0.1, 0.0, 0.8), Eigen::Vector3d(0.2, 0.0, 0.5)};
  std::array<Eigen::Vector3d, 2> body_velocities{Eigen::Vector3d(0.3, 0.1, -0.2), Eigen::Vector3d(0.5, -0.1, 0.4)};
  std::array<Eigen::Quaterniond, 2> orientations{Eigen::Quaterniond::Identity(), Eigen::Quaterniond::Identity()};
  std::array<Eigen::Vector3d, 2> spins{Eigen::Vector3d(0.0, 0.7, 0.0), Eigen::Vector3d(0.0, -0.4, 0.1)};

  double time = 0.25;  // s

  StepView view() const {
    return {time,        positions,      velocities,      forces,       coordinates, coordinates,
            coordinates, body_positions, body_velocities, orientations, spins};
  }
  void go_to(int step) {
    constexpr double kRate = 0.4;  // rad a step
    if (step == 0) return;
    const double phase = kRate * step;
    time = 0.25 + kStep * step;
    positions = {0.3 + 0.5 * std::sin(phase), -0.2 - 0.4 * std::sin(phase)};
    velocities = {0.7 * std::cos(phase), -1.1 * std::cos(phase)};
    forces = {0.4 * std::cos(2.0 * phase), 0.1 * std::sin(phase)};
  }
};

/// The loads on the robot, in separate memory.
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

/// As left by other effects.
Loads loads_of_others() {
  Loads loads;
  for (JointLoad& load : loads.joints) load = {7.3, -5.1, 4.3, 3.3, 2.9};
  for (BodyLoad& load : loads.bodies) load = {{1.3, 2.7, -3.1}, {0.7, -1.9, 2.3}, 1.7, 0.9};
  return loads;
}

/// A placed effect, the memory of its hooks, and the calls of one step in their order.
class Placed {
 public:
  Placed(const PhysicalEffect& effect, ElementKind kind, const std::vector<int>& elements,
         const std::vector<double>& values, double guard)
      : effect_(effect), kind_(kind), parameters_(values, guard), elements_(elements, 0), state_({}, kBesideState) {}

  EffectContext context() { return {parameters_.numbers(), elements_.numbers(), kind_, kStep}; }
  /// False: it needs more than the host gives.
  bool make_state(int size) {
    if (size < 0 || size > kLargestState) return false;
    state_ = Guarded<double>(std::vector<double>(static_cast<std::size_t>(size), 0.0), kBesideState);
    return true;
  }
  std::span<double> state() { return state_.numbers(); }
  bool has_intact_state() const { return state_.is_intact(); }

  Moment moment;
  Loads loads;
  bool has_others = false;
  bool replaced_loads = false;
  double commanded = 0.0;
  std::array<double, 1> channels{};

  /// `visit(name of the hook, a function that calls it)` for each hook of a step.
  template <class Visit>
  void each_hook(Visit&& visit) {
    const OverriddenHooks& hooks = effect_.overridden();
    if (hooks.command && kind_ == ElementKind::actuator)
      visit("command", [this] { commanded = effect_.command(0.8, 0, moment.view(), context(), state()); });
    if (hooks.add_loads) visit("add_loads", [this] { add_loads(); });
    if (hooks.advance) visit("advance", [this] { effect_.advance(moment.view(), context(), state()); });
    if (hooks.sense && kind_ == ElementKind::sensor)
      visit("sense", [this] {
        channels = {0.6};
        effect_.sense(channels, 0, moment.view(), context(), state());
      });
  }

 private:
  static constexpr double kBesideState = 0.37;

  void add_loads() {
    loads = has_others ? loads_of_others() : Loads{};
    StepLoads given = loads.view();
    effect_.add_loads(moment.view(), context(), state(), given);
    if (given.joints.data() != loads.joints.data() || given.joints.size() != loads.joints.size() ||
        given.bodies.data() != loads.bodies.data() || given.bodies.size() != loads.bodies.size())
      replaced_loads = true;
  }

  const PhysicalEffect& effect_;
  ElementKind kind_;
  Guarded<double> parameters_;
  Guarded<int> elements_;
  Guarded<double> state_;
};

/// Number of allocations of the call.
template <class Call>
long call(const EffectConditions& conditions, const char* what, Call&& hook) {
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

std::vector<double> results_of(std::string_view hook, Placed& placed) {
  if (hook == "command") return {placed.commanded};
  if (hook == "sense") return {placed.channels.begin(), placed.channels.end()};
  if (hook == "advance") return {placed.state().begin(), placed.state().end()};
  std::vector<double> all = placed.loads.summands();
  const Loads& loads = placed.loads;
  all.insert(all.end(), {loads.contact.stiffness, loads.contact.damping, loads.contact.friction, loads.contact.slope,
                         loads.gravity.x(), loads.gravity.y(), loads.gravity.z()});
  return all;
}

/// Where allocations are counted, a hook is called twice, because it may allocate once for later calls.
void take_step(const EffectConditions& conditions, Placed& placed, EffectCourse& course) {
  placed.each_hook([&](const char* hook, const auto& function) {
    call(conditions, hook, function);
    if (conditions.counts_allocations) course.allocations.emplace_back(hook, call(conditions, hook, function));
    course.results.emplace_back(hook, results_of(hook, placed));
    if (std::string_view(hook) == "add_loads") course.summands = placed.loads.summands();
  });
}

void call_hooks(const PhysicalEffect& effect, const EffectConditions& conditions, std::span<const double> largest,
                Placed& placed, EffectCourse& course) {
  RobotSpec robot = two_links();
  if (effect.overridden().amend) call(conditions, "amend", [&] { effect.amend(robot, placed.context()); });
  course.results.emplace_back("amend", numbers_of(robot));
  int size = 0;
  EffectContext for_size = placed.context();
  for_size.parameters = largest;
  call(conditions, "state_size", [&] { size = effect.state_size(for_size); });
  course.results.emplace_back("state_size", std::vector<double>{static_cast<double>(size)});
  if (!placed.make_state(size)) return;
  call(conditions, "start", [&] { effect.start(placed.moment.view(), placed.context(), placed.state()); });
  course.results.emplace_back("start", std::vector<double>(placed.state().begin(), placed.state().end()));
  for (int step = 0; step < conditions.steps; ++step) {
    placed.moment.go_to(step);
    take_step(conditions, placed, course);
  }
}

constexpr int kCallsAtOnce = 200, kBatches = 31;

/// Number of calls in a row, so that the clock's own time does not matter.
template <class Call>
HookCost cost_of(const char* name, const Call& call) {
  using Clock = std::chrono::steady_clock;
  const PluginCall active(own_call_slot().component, name);
  for (int i = 0; i < kCallsAtOnce; ++i) call();
  const long before = allocations_of_this_thread();
  for (int i = 0; i < kCallsAtOnce; ++i) call();
  const long allocated = allocations_of_this_thread() - before;
  std::vector<double> seconds;
  for (int batch = 0; batch < kBatches; ++batch) {
    const auto start = Clock::now();
    for (int i = 0; i < kCallsAtOnce; ++i) call();
    seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count() / kCallsAtOnce);
  }
  std::nth_element(seconds.begin(), seconds.begin() + kBatches / 2, seconds.end());
  return {name, (allocated + kCallsAtOnce - 1) / kCallsAtOnce, seconds[kBatches / 2]};
}

}  // namespace

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

double value_to_try(const ParameterDeclaration& parameter) {
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

EffectTrial::EffectTrial(const PhysicalEffect& effect, const EffectDescription& description, ElementKind kind,
                         std::vector<int> elements, std::vector<double> values)
    : effect_(effect), kind_(kind), elements_(std::move(elements)), values_(std::move(values)) {
  for (const ParameterDeclaration& parameter : description.parameters) largest_.push_back(parameter.upper);
}

EffectCourse EffectTrial::go(const EffectConditions& conditions) const {
  EffectCourse course;
  Placed placed(effect_, kind_, elements_, values_, conditions.guard);
  placed.has_others = conditions.has_others;
  try {
    call_hooks(effect_, conditions, largest_, placed, course);
  } catch (const ProcessChanged&) {
    throw;
  } catch (...) {
    course.thrown = std::current_exception();
  }
  course.replaced_loads = placed.replaced_loads;
  course.kept_to_state = placed.has_intact_state();
  return course;
}

std::vector<HookCost> EffectTrial::costs() const {
  Placed placed(effect_, kind_, elements_, values_, EffectConditions{}.guard);
  EffectCourse unused;
  EffectConditions at_start;
  at_start.steps = 0;
  call_hooks(effect_, at_start, largest_, placed, unused);
  std::vector<HookCost> costs;
  placed.each_hook([&](const char* hook, const auto& function) {
    costs.push_back(cost_of(hook, [&] {
      placed.moment.time += kStep;
      function();
    }));
  });
  return costs;
}

/// The first call with a different result; null: none.
const char* first_difference(const EffectCourse& a, const EffectCourse& b) {
  for (std::size_t i = 0; i < std::min(a.results.size(), b.results.size()); ++i) {
    const std::vector<double>& ours = a.results[i].second;
    const std::vector<double>& theirs = b.results[i].second;
    if (!std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end(), same_bits)) return a.results[i].first;
  }
  if (a.results.size() == b.results.size() && a.threw() == b.threw()) return nullptr;
  const EffectCourse& longer = a.results.size() > b.results.size() ? a : b;
  return longer.results.back().first;
}

std::vector<double> summands_of_others() { return loads_of_others().summands(); }

}  // namespace lacuna
