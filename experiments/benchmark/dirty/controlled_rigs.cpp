#include "dirty/rig_parts.h"

#include <algorithm>

/// Rigs of one joint under a controller.
namespace hidden_effects::dirty {
namespace {

/// How often a loop of a rate is sampled: a controller acts ten times in its own time constant at least.
void sample_loop(DirtyRig& rig, double loop_rate, RigDraw& draw) {
  const double least = std::max(50.0, 12.0 * loop_rate);
  const double frequency = std::round(draw.log_between(least, std::max(1.3 * least, kFastest)) / 10.0) * 10.0;
  rig.interval = 1.0 / std::min(frequency, kFastest);
  const double duration = std::min(kLongest, kTurn / rig.rate * draw.log_between(4.0, 40.0));
  const auto samples = static_cast<std::size_t>(duration / rig.interval);
  rig.trials = empty_trials(std::clamp(samples, std::size_t{200}, kMostSamples), rig.stated.joints.size(), draw);
}

void follow_waves(DirtyRig& rig, double size, RigDraw& draw) {
  for (TrialPlan& trial : rig.trials) {
    trial.reference = {wave(any_wave(draw), trial.samples, rig.interval, 0.2 * rig.rate, 1.5 * rig.rate, draw)};
    const double own = size * draw.between(0.6, 1.2);
    for (double& value : trial.reference[0]) value *= own;
  }
}

Loop position_law(double inertia, double loop_rate, double more_stiffness, RigDraw& draw) {
  Loop loop;
  loop.proportional = inertia * loop_rate * loop_rate + more_stiffness;
  loop.derivative = 2.0 * draw.between(0.5, 0.9) * inertia * loop_rate;
  if (draw.chance(0.3)) loop.integral = 0.2 * loop.proportional * loop_rate;
  return loop;
}

}  // namespace

/// A geared servo that holds a link at the position that it is told; its goals are recorded.
DirtyRig position_servo(RigDraw& draw) {
  DirtyRig rig;
  const double mass = draw.log_between(0.02, 15.0), lever = length_for(mass, draw);
  rig.stated.bodies = {hanging("link", mass, draw.chance(0.7) ? -lever : lever, draw.between(0.1, 0.4))};
  rig.stated.joints = {{.name = "output"}};
  rig.stated.sensors = {{"angle", 0}};
  const double rotor = draw.between(0.2, 1.5) * inertia_at(rig.stated, 0);
  rig.stated.drives = {{.name = "servo", .joint = 0, .servo = true, .rotor_inertia = rotor}};
  const double inertia = inertia_at(rig.stated, 0), weight = mass * kGravity * lever;
  const double loop_rate = std::sqrt(draw.log_between(3.0, 30.0) * weight / inertia);
  rig.stated.drives[0].kp = inertia * loop_rate * loop_rate;
  rig.stated.drives[0].kd = 2.0 * draw.between(0.3, 0.9) * inertia * loop_rate;
  rig.driving = Driving::servo;
  rig.rate = 0.5 * loop_rate;
  rig.fastest = 2.0 * loop_rate;
  fit_or_state(rig, {Quantity::kp, 0}, 0.8, draw);
  fit_or_state(rig, {Quantity::kd, 0}, 0.8, draw);
  rig.fixed.push_back({Quantity::mass, 0});
  rig.fixed.push_back({Quantity::inertia, 0});
  const Sampling sampled = sampling(rig.rate, 6.0, 80.0, 14.0, 120.0, draw);
  rig.interval = sampled.interval;
  rig.trials = empty_trials(sampled.samples, 1, draw);
  follow_waves(rig, draw.between(0.3, 0.9), draw);
  rig.longest = 2.0 * kTurn / rig.rate;
  rig.noise = draw.log_between(2e-4, 4e-3);
  return rig;
}

/// A hinge or a slider under a position controller outside, whose forces are recorded.
DirtyRig controlled_axis(RigDraw& draw) {
  DirtyRig rig;
  const bool slides = draw.chance(0.5);
  const double mass = draw.log_between(0.05, 100.0), lever = length_for(mass, draw);
  if (slides)
    rig.stated.bodies = {{"carriage", mass, InPlane::Zero(), 0.01 * mass}};
  else
    rig.stated.bodies = {hanging("arm", mass, -lever, draw.between(0.1, 0.4))};
  rig.stated.joints = {{.name = slides ? "slider" : "hinge", .slides = slides}};
  rig.stated.sensors = {{slides ? "position" : "angle", 0}};
  const double rotor = draw.between(0.05, 0.5) * inertia_at(rig.stated, 0);
  rig.stated.drives = {{.name = "motor", .joint = 0, .rotor_inertia = rotor}};
  rig.driving = Driving::position_loop;
  const double inertia = inertia_at(rig.stated, 0);
  const double own_rate = slides ? 0.0 : std::sqrt(mass * kGravity * lever / inertia);
  const double loop_rate = slides ? draw.log_between(5.0, 60.0) : own_rate * draw.log_between(1.5, 6.0);
  rig.loops = {position_law(inertia, loop_rate, 0.0, draw)};
  rig.rate = 0.4 * loop_rate;
  rig.fastest = 2.0 * loop_rate;
  maybe_damp(rig, 0, draw.log_between(0.02, 0.2), draw);
  fit_or_state(rig, {Quantity::mass, 0}, slides ? 0.6 : 0.5, draw);
  if (!slides) fit_or_state(rig, {Quantity::inertia, 0}, 0.4, draw);
  rig.fixed.push_back({Quantity::gain, 0});
  sample_loop(rig, loop_rate, draw);
  follow_waves(rig, slides ? 0.1 * std::cbrt(mass) * draw.log_between(0.3, 2.0) : draw.between(0.3, 1.0), draw);
  rig.longest = kTurn / rig.rate;
  rig.noise = draw.log_between(5e-5, 1e-3);
  return rig;
}

/// A wheel, an axis or a slider under a velocity controller, whose forces are recorded.
DirtyRig velocity_axis(RigDraw& draw) {
  DirtyRig rig;
  const bool slides = draw.chance(0.35), by_speed = draw.chance(0.4);
  const double mass = draw.log_between(0.05, 100.0), radius = length_for(mass, draw);
  rig.stated.bodies = {{slides ? "carriage" : "wheel", mass, InPlane::Zero(), 0.5 * mass * radius * radius}};
  rig.stated.joints = {{.name = slides ? "rail" : "axle", .slides = slides}};
  rig.stated.sensors = {{by_speed ? "speed" : slides ? "place" : "angle", 0, by_speed}};
  rig.stated.drives = {
      {.name = "motor", .joint = 0, .rotor_inertia = draw.between(0.05, 0.5) * inertia_at(rig.stated, 0)}};
  rig.driving = Driving::velocity_loop;
  const double inertia = inertia_at(rig.stated, 0), loop_rate = draw.log_between(3.0, 40.0);
  rig.loops = {{.proportional = inertia * loop_rate, .integral = 0.25 * inertia * loop_rate * loop_rate}};
  rig.rate = 0.3 * loop_rate;
  rig.fastest = 2.0 * loop_rate;
  maybe_damp(rig, 0, draw.log_between(0.05, 0.3), draw);
  fit_or_state(rig, {slides ? Quantity::mass : Quantity::inertia, 0}, 0.5, draw);
  rig.fixed.push_back({Quantity::gain, 0});
  rig.fixed.push_back({Quantity::scale, 0});
  sample_loop(rig, loop_rate, draw);
  follow_waves(rig, slides ? draw.log_between(0.1, 1.0) : draw.log_between(2.0, 60.0), draw);
  rig.longest = kTurn / rig.rate;
  rig.noise = by_speed ? draw.log_between(1e-3, 8e-3) : draw.log_between(3e-5, 5e-4);
  return rig;
}

/// An arm that stands upright, held by a controller whose torque is recorded: unstable without it.
DirtyRig upright_pendulum(RigDraw& draw) {
  DirtyRig rig;
  const double mass = draw.log_between(0.05, 30.0), lever = length_for(mass, draw);
  rig.stated.bodies = {hanging("arm", mass, lever, draw.between(0.1, 0.4))};
  rig.stated.joints = {{.name = "hinge"}};
  rig.stated.sensors = {{"angle", 0}};
  const double rotor = draw.between(0.05, 0.3) * inertia_at(rig.stated, 0);
  rig.stated.drives = {{.name = "motor", .joint = 0, .rotor_inertia = rotor}};
  rig.driving = Driving::position_loop;
  const double inertia = inertia_at(rig.stated, 0), weight = mass * kGravity * lever;
  const double falling_rate = std::sqrt(weight / inertia), loop_rate = falling_rate * draw.log_between(1.5, 4.0);
  rig.loops = {position_law(inertia, loop_rate, weight, draw)};
  rig.rate = falling_rate;
  rig.fastest = 2.0 * loop_rate;
  maybe_damp(rig, 0, draw.log_between(0.02, 0.1), draw);
  fit_or_state(rig, {Quantity::mass, 0}, 0.5, draw);
  fit_or_state(rig, {Quantity::inertia, 0}, 0.4, draw);
  rig.fixed.push_back({Quantity::gain, 0});
  rig.fixed.push_back({Quantity::lever, 0});
  sample_loop(rig, loop_rate, draw);
  follow_waves(rig, draw.between(0.15, 0.6), draw);
  rig.longest = 1.5 / falling_rate;
  rig.noise = draw.log_between(1e-4, 1e-3);
  return rig;
}

}  // namespace hidden_effects::dirty
