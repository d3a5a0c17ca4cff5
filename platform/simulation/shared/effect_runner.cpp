#include "simulation/shared/effect_runner.h"

#include <lacuna/error.h>

#include <algorithm>
#include <cmath>

namespace lacuna::simulation {
namespace {

constexpr const char* kRepair = "; repair the plugin, or take the effect out of the model";

bool sound(const JointLoad& load) {
  return std::isfinite(load.force) && load.friction_lower <= 0.0 && load.friction_upper >= 0.0 && load.damping >= 0.0 &&
         load.stiffness >= 0.0 && std::isfinite(load.damping) && std::isfinite(load.stiffness);
}

bool sound(const BodyLoad& load) {
  return load.force.allFinite() && load.torque.allFinite() && load.damping >= 0.0 && std::isfinite(load.damping) &&
         load.angular_damping >= 0.0 && std::isfinite(load.angular_damping);
}

bool sound(const ContactSpec& contact) {
  return contact.stiffness > 0.0 && contact.damping >= 0.0 && std::isfinite(contact.damping) &&
         contact.friction >= 0.0 && std::isfinite(contact.slope) && contact.impact_damping >= 0.0 &&
         contact.restitution >= 0.0 && contact.restitution <= 1.0 && contact.rolling_lever >= 0.0 &&
         contact.creep >= 0.0;
}

bool sound(const StepLoads& loads) {
  return std::all_of(loads.joints.begin(), loads.joints.end(), [](const JointLoad& load) { return sound(load); }) &&
         std::all_of(loads.bodies.begin(), loads.bodies.end(), [](const BodyLoad& load) { return sound(load); }) &&
         sound(loads.contact) && loads.gravity.allFinite();
}

}  // namespace

void EffectRunner::amend(RobotSpec& robot) {
  running_ = kNone;
  call_.emplace();
  const std::size_t sizes[] = {robot.bodies.size(), robot.joints.size(), robot.actuators.size(), robot.sensors.size()};
  for (const std::size_t effect : schedule_.amending()) {
    enter(effect, "amend");
    schedule_.effects()[effect].effect->amend(robot, context(effect));
    check();
    if (sizes[0] != robot.bodies.size() || sizes[1] != robot.joints.size() || sizes[2] != robot.actuators.size() ||
        sizes[3] != robot.sensors.size())
      throw Error("it added or removed elements of the robot, which an effect must not do");
  }
  leave();
}

void EffectRunner::start(const StepView& view) {
  std::fill(states_.begin(), states_.end(), 0.0);
  for (std::size_t effect = 0; effect < schedule_.effects().size(); ++effect) {
    enter(effect, "start");
    schedule_.effects()[effect].effect->start(view, context(effect), state(effect));
    check();
  }
  leave();
}

void EffectRunner::add_loads_of(std::size_t effect, const StepView& view, double length, StepLoads& loads) {
  const JointLoad* const joints = loads.joints.data();
  const BodyLoad* const bodies = loads.bodies.data();
  enter(effect, "add_loads");
  schedule_.effects()[effect].effect->add_loads(view, context(effect, length), state(effect), loads);
  check();
  if (loads.joints.data() != joints || loads.bodies.data() != bodies)
    throw Error(std::string("it replaced the list of loads; it may only add to its elements") + kRepair);
}

void EffectRunner::add_loads(const StepView& view, double length, StepLoads& loads) {
  for (const std::size_t effect : schedule_.loading()) add_loads_of(effect, view, length, loads);
  leave();
  if (!sound(loads)) throw_culprit(view, length, loads);
}

void EffectRunner::throw_culprit(const StepView& view, double length, StepLoads& loads) {
  const ContactSpec contact = instance_.robot().contact;
  for (const std::size_t effect : schedule_.loading()) {
    std::fill(loads.joints.begin(), loads.joints.end(), JointLoad{});
    std::fill(loads.bodies.begin(), loads.bodies.end(), BodyLoad{});
    loads.contact = contact;
    loads.gravity = instance_.robot().gravity;
    add_loads_of(effect, view, length, loads);
    if (!sound(loads)) throw Error(std::string("it wrote a load that is not finite or has the wrong sign") + kRepair);
  }
  leave();
  throw Error("the effects together wrote a load that is not finite or has the wrong sign");
}

void EffectRunner::advance(const StepView& view, double length) {
  if (schedule_.advancing().empty()) return;
  for (const std::size_t effect : schedule_.advancing()) {
    enter(effect, "advance");
    schedule_.effects()[effect].effect->advance(view, context(effect, length), state(effect));
    check();
  }
  leave();
}

double EffectRunner::command(std::size_t actuator, double value, const StepView& view) {
  if (schedule_.commands(actuator).empty()) return value;
  for (const auto& [effect, which] : schedule_.commands(actuator)) {
    enter(effect, "command");
    value = schedule_.effects()[effect].effect->command(value, which, view, context(effect), state(effect));
    check();
    if (!std::isfinite(value)) throw Error(std::string("its command is not a number") + kRepair);
  }
  leave();
  return value;
}

void EffectRunner::sense(std::size_t sensor, std::span<double> channels, const StepView& view) {
  if (schedule_.senses(sensor).empty()) return;
  for (const auto& [effect, which] : schedule_.senses(sensor)) {
    enter(effect, "sense");
    schedule_.effects()[effect].effect->sense(channels, which, view, context(effect), state(effect));
    check();
    if (!std::all_of(channels.begin(), channels.end(), [](double reading) { return std::isfinite(reading); }))
      throw Error(std::string("its reading is not a number") + kRepair);
  }
  leave();
}

double EffectRunner::lateness(std::size_t sensor, double time) {
  if (schedule_.senses(sensor).empty()) return 0.0;
  double sum = 0.0;
  for (const auto& [effect, which] : schedule_.senses(sensor)) {
    enter(effect, "lateness");
    sum += schedule_.effects()[effect].effect->lateness(time, context(effect));
    check();
    if (!std::isfinite(sum)) throw Error(std::string("its lateness is not a number") + kRepair);
  }
  leave();
  return sum;
}

void EffectRunner::end() const {
  if (schedule_.effects().empty()) return;
  const std::string changed = ProcessWatch::changed();
  if (changed.empty()) return;
  std::string names;
  for (const PlacedEffect& placed : schedule_.effects())
    names += (names.empty() ? "" : " or ") + to_string(origin_of(placed));
  throw Error(names + " changed " + changed + ", which other code relies on; it was set back" + kRepair);
}

std::string EffectRunner::explain() {
  const std::size_t effect = running_;
  if (effect != kNone) {
    const PlacedEffect& placed = schedule_.effects()[effect];
    const std::string reason = describe_current_exception(origin_of(placed), hook_);  // may call the plugin again
    ProcessWatch::changed();
    leave();  // the next failure may have another cause than an effect
    return "effect." + placed.id + ": " + reason;
  }
  try {
    throw;
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "an exception of an unknown type was thrown";
  }
}

}  // namespace lacuna::simulation
