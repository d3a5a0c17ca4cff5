#include "dirty/rig_parts.h"

#include <algorithm>

/// Rigs that are let go: nothing drives them.
namespace hidden_effects::dirty {

/// An arm that swings out, tracked by an encoder or a camera.
DirtyRig free_pendulum(RigDraw& draw) {
  DirtyRig rig;
  const double mass = draw.log_between(0.01, 30.0), lever = length_for(mass, draw);
  rig.stated.bodies = {hanging("pendulum", mass, -lever, draw.between(0.05, 0.4))};
  rig.stated.joints = {{.name = "hinge"}};
  rig.stated.sensors = {{"angle", 0}};
  rig.rate = std::sqrt(mass * kGravity * lever / inertia_at(rig.stated, 0));
  rig.fastest = 1.5 * rig.rate;
  maybe_damp(rig, 0, draw.log_between(0.002, 0.02), draw);
  fit_or_state(rig, {Quantity::inertia, 0}, 0.5, draw);
  rig.fixed.push_back({Quantity::lever, 0});
  rig.fixed.push_back({Quantity::mass, 0});
  rig.fixed.push_back({Quantity::scale, 0});
  const Sampling sampled = sampling(rig.rate, 6.0, 60.0, 14.0, 200.0, draw);
  rig.interval = sampled.interval;
  rig.trials = empty_trials(sampled.samples, 1, draw);
  for (TrialPlan& trial : rig.trials) trial.start.position[0] = draw.sign() * draw.between(0.3, 2.3);
  rig.longest = 5.0 * kTurn / rig.rate;
  rig.noise = draw.log_between(2e-4, 4e-3);
  return rig;
}

/// A mass between springs, or one that hangs from a spring, pulled aside.
DirtyRig spring_oscillator(RigDraw& draw) {
  DirtyRig rig;
  const double mass = draw.log_between(0.02, 80.0);
  const bool hangs = draw.chance(0.5);
  rig.rate = draw.log_between(3.0, 60.0) * std::pow(mass, -0.15);
  rig.fastest = rig.rate;
  rig.stated.bodies = {{"mass", mass, InPlane::Zero(), 0.01 * mass}};
  rig.stated.joints = {{.name = hangs ? "spring" : "slide",
                        .slides = true,
                        .axis = hangs ? InPlane(0.0, 1.0) : InPlane(1.0, 0.0),
                        .stiffness = mass * rig.rate * rig.rate}};
  rig.stated.sensors = {{hangs ? "height" : "position", 0}};
  const double sag = hangs ? kGravity / (rig.rate * rig.rate) : 0.0;
  if (hangs) rig.stated.joints[0].rest = sag;
  maybe_damp(rig, 0, draw.log_between(0.002, 0.02), draw);
  fit_or_state(rig, {Quantity::stiffness, 0}, 0.6, draw);
  if (hangs) fit_or_state(rig, {Quantity::rest, 0}, 0.8, draw);
  rig.fixed.push_back({Quantity::mass, 0});
  const Sampling sampled = sampling(rig.rate, 6.0, 80.0, 14.0, 200.0, draw);
  rig.interval = sampled.interval;
  rig.trials = empty_trials(sampled.samples, 1, draw);
  const double pulled = 0.05 * std::cbrt(mass) * draw.log_between(0.3, 2.0);
  for (TrialPlan& trial : rig.trials) trial.start.position[0] = draw.sign() * pulled * draw.between(0.5, 1.0);
  rig.longest = 5.0 * kTurn / rig.rate;
  rig.noise = draw.log_between(2e-4, 4e-3);
  return rig;
}

/// A body that is dropped or thrown up, followed by a camera or an altimeter.
DirtyRig falling_body(RigDraw& draw) {
  DirtyRig rig;
  const double mass = draw.log_between(0.01, 40.0);
  const double way = draw.log_between(2.0, 120.0), up = draw.chance(0.3) ? std::sqrt(kGravity * way) : 0.0;
  const double duration = (up + std::sqrt(up * up + 2.0 * kGravity * way)) / kGravity;
  rig.stated.bodies = {{"body", mass, InPlane::Zero(), 0.004 * mass}};
  rig.stated.joints = {{.name = "fall", .slides = true, .axis = {0.0, 1.0}}};
  rig.stated.sensors = {{"height", 0}};
  rig.rate = kTurn / duration;
  rig.fastest = 4.0 * rig.rate;
  rig.fixed = {{Quantity::mass, 0}, {Quantity::scale, 0}};
  const double least = std::max(26.0, 16.0 * duration), most = draw.chance(0.4) ? 1.1 : 12.0;
  const Sampling sampled = sampling(rig.rate, 0.9, 1.0, least, most * least, draw);
  rig.interval = sampled.interval;
  rig.trials = empty_trials(sampled.samples, 1, draw);
  for (TrialPlan& trial : rig.trials) {
    trial.start.position[0] = way * draw.between(0.9, 1.1);
    trial.start.velocity[0] = up * draw.between(0.9, 1.1);
  }
  rig.longest = duration;
  rig.force = mass * kGravity;
  rig.noise = draw.log_between(5e-4, 6e-3);
  return rig;
}

/// A balanced wheel, a rotor or a carriage that runs down from its speed.
DirtyRig wheel_running_down(RigDraw& draw) {
  DirtyRig rig;
  const double mass = draw.log_between(0.05, 100.0), radius = length_for(mass, draw);
  const bool slides = draw.chance(0.25), by_speed = draw.chance(0.35);
  const double duration = draw.log_between(4.0, 115.0);
  const double speed = slides ? draw.log_between(0.3, 3.0) : draw.log_between(8.0, 120.0);
  rig.stated.bodies = {{slides ? "carriage" : "wheel", mass, InPlane::Zero(), 0.5 * mass * radius * radius}};
  rig.stated.joints = {{.name = slides ? "rail" : "axle", .slides = slides}};
  rig.stated.sensors = {{by_speed ? "speed" : slides ? "place" : "angle", 0, by_speed}};
  rig.rate = 1.0 / duration;
  rig.fastest = 10.0 * rig.rate;
  maybe_damp(rig, 0, draw.log_between(0.1, 0.4), draw);
  rig.fixed.push_back({slides ? Quantity::mass : Quantity::inertia, 0});
  rig.fixed.push_back({Quantity::scale, 0});
  const double frequency = std::round(draw.log_between(kSlowest, 300.0));
  rig.interval = 1.0 / frequency;
  rig.trials = empty_trials(std::min(kMostSamples, static_cast<std::size_t>(duration * frequency)), 1, draw);
  for (TrialPlan& trial : rig.trials) trial.start.velocity[0] = speed * draw.between(0.5, 1.0);
  rig.longest = 0.4 * duration;
  rig.force = inertia_at(rig.stated, 0) * speed / duration;
  rig.noise = by_speed ? draw.log_between(1e-3, 1e-2) : draw.log_between(3e-6, 3e-4);
  return rig;
}

}  // namespace hidden_effects::dirty
