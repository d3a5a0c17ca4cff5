#include "dirty/rig_parts.h"

#include <algorithm>

/// Rigs of one joint with a drive of open loop, or a bench that moves them.
namespace hidden_effects::dirty {
namespace {

/// The same wave for all files or another one for each, of one size.
void drive_by_waves(DirtyRig& rig, double size, double slowest, double fastest, RigDraw& draw) {
  for (TrialPlan& trial : rig.trials) {
    trial.reference = {wave(any_wave(draw), trial.samples, rig.interval, slowest, fastest, draw)};
    const double own = size * draw.between(0.6, 1.2);
    for (double& value : trial.reference[0]) value *= own;
  }
}

void sample_driven(DirtyRig& rig, RigDraw& draw) {
  const Sampling sampled = sampling(rig.rate, 6.0, 60.0, 16.0, 300.0, draw);
  rig.interval = sampled.interval;
  rig.trials = empty_trials(sampled.samples, 1, draw);
  rig.longest = 5.0 * kTurn / rig.rate;
  rig.noise = draw.log_between(2e-4, 4e-3);
}

}  // namespace

/// An arm on a motor whose torque is commanded.
DirtyRig driven_pendulum(RigDraw& draw) {
  DirtyRig rig;
  const double mass = draw.log_between(0.02, 30.0), lever = length_for(mass, draw);
  rig.stated.bodies = {hanging("arm", mass, -lever, draw.between(0.1, 0.4))};
  rig.stated.joints = {{.name = "hinge"}};
  rig.stated.sensors = {{"angle", 0}};
  const double rotor = draw.between(0.05, 0.4) * inertia_at(rig.stated, 0);
  rig.stated.drives = {{.name = "motor", .joint = 0, .rotor_inertia = rotor}};
  rig.driving = Driving::open_loop;
  rig.rate = std::sqrt(mass * kGravity * lever / inertia_at(rig.stated, 0));
  rig.fastest = 3.0 * rig.rate;
  damp(rig, 0, draw.log_between(0.05, 0.2), draw);  // else it would swing itself over the top
  fit_or_state(rig, {Quantity::mass, 0}, 0.5, draw);
  fit_or_state(rig, {Quantity::inertia, 0}, 0.4, draw);
  rig.fixed.push_back({Quantity::gain, 0});
  rig.fixed.push_back({Quantity::lever, 0});
  rig.fixed.push_back({Quantity::scale, 0});
  sample_driven(rig, draw);
  rig.longest = 3.0 * kTurn / rig.rate;  // a swing over the top is soon another one
  drive_by_waves(rig, draw.between(0.12, 0.4) * mass * kGravity * lever, 0.15 * rig.rate, 1.8 * rig.rate, draw);
  return rig;
}

/// A carriage between springs that a linear motor pushes.
DirtyRig driven_slider(RigDraw& draw) {
  DirtyRig rig;
  const double mass = draw.log_between(0.05, 100.0);
  rig.rate = draw.log_between(2.0, 40.0) * std::pow(mass, -0.1);
  rig.fastest = 3.0 * rig.rate;
  rig.stated.bodies = {{"carriage", mass, InPlane::Zero(), 0.01 * mass}};
  rig.stated.joints = {{.name = "slider", .slides = true, .stiffness = mass * rig.rate * rig.rate}};
  rig.stated.sensors = {{"position", 0}};
  rig.stated.drives = {{.name = "motor", .joint = 0, .rotor_inertia = draw.chance(0.5) ? 0.1 * mass : 0.0}};
  rig.driving = Driving::open_loop;
  maybe_damp(rig, 0, draw.log_between(0.02, 0.2), draw);
  fit_or_state(rig, {Quantity::mass, 0}, 0.6, draw);
  fit_or_state(rig, {Quantity::stiffness, 0}, 0.6, draw);
  rig.fixed.push_back({Quantity::gain, 0});
  sample_driven(rig, draw);
  const double reach = 0.05 * std::cbrt(mass) * draw.log_between(0.3, 2.0);
  drive_by_waves(rig, 0.6 * mass * rig.rate * rig.rate * reach, 0.15 * rig.rate, 2.0 * rig.rate, draw);
  return rig;
}

/// A wheel or an arm on a DC motor whose voltage is commanded.
DirtyRig voltage_motor(RigDraw& draw) {
  DirtyRig rig;
  const double mass = draw.log_between(0.03, 30.0), radius = length_for(mass, draw);
  const bool hangs = draw.chance(0.4), by_speed = !hangs && draw.chance(0.5);
  if (hangs)
    rig.stated.bodies = {hanging("arm", mass, -radius, 0.3)};
  else
    rig.stated.bodies = {{"wheel", mass, InPlane::Zero(), 0.5 * mass * radius * radius}};
  rig.stated.joints = {{.name = "shaft"}};
  rig.stated.sensors = {{by_speed ? "speed" : "angle", 0, by_speed}};
  const double inertia = inertia_at(rig.stated, 0);
  rig.rate = hangs ? std::sqrt(mass * kGravity * radius / inertia) : draw.log_between(1.0, 20.0);
  // Back-EMF damps at about the rig's rate; the supply is one of 6 to 48 V.
  const double volts = draw.log_between(6.0, 48.0);
  const double top_speed = hangs ? 8.0 * rig.rate : draw.log_between(10.0, 200.0);
  const double constant = volts / top_speed;
  const double resistance = constant * constant / (inertia * rig.rate);
  rig.stated.drives = {{.name = "motor",
                        .joint = 0,
                        .rotor_inertia = 0.1 * inertia,
                        .torque_constant = constant,
                        .resistance = resistance}};
  rig.driving = Driving::open_loop;
  rig.fastest = 3.0 * rig.rate;
  fit_or_state(rig, {Quantity::torque_constant, 0}, 0.5, draw);
  maybe_damp(rig, 0, draw.log_between(0.02, 0.1), draw);
  fit_or_state(rig, {Quantity::inertia, 0}, 0.5, draw);
  rig.fixed.push_back({Quantity::scale, 0});
  sample_driven(rig, draw);
  if (!hangs) rig.longest = 6.0 / rig.rate;
  const double torque = hangs ? draw.between(0.3, 0.6) * mass * kGravity * radius : 0.0;
  const double size = hangs ? torque * resistance / constant : volts * draw.between(0.25, 0.6);
  drive_by_waves(rig, size, 0.15 * rig.rate, 1.5 * rig.rate, draw);
  return rig;
}

/// A bench that moves a joint to and fro and reads the force.
DirtyRig imposed_motion(RigDraw& draw) {
  DirtyRig rig;
  const bool slides = draw.chance(0.7);
  const double mass = draw.log_between(0.02, 30.0), radius = length_for(mass, draw);
  rig.stated.bodies = {{slides ? "rod" : "disc", mass, InPlane::Zero(), 0.5 * mass * radius * radius}};
  rig.stated.joints = {{.name = slides ? "guide" : "bearing", .slides = slides}};
  rig.stated.sensors = {{"position", 0}, {"force", 0}};
  rig.stated.drives = {{.name = "bench", .joint = 0}};
  rig.driving = Driving::imposed;
  rig.rate = kTurn * draw.log_between(0.1, 3.0);
  rig.fastest = 6.0 * rig.rate;
  const double reach = slides ? 0.05 * std::cbrt(mass) * draw.log_between(0.2, 2.0) : draw.between(0.2, 1.5);
  rig.force = inertia_at(rig.stated, 0) * reach * rig.rate * rig.rate * draw.log_between(1.0, 30.0);
  if (draw.chance(0.4)) {
    rig.stated.joints[0].stiffness = 0.5 * rig.force / reach;
    fit_or_state(rig, {Quantity::stiffness, 0}, 0.6, draw);
  }
  maybe_damp(rig, 0, 0.5, draw);
  fit_or_state(rig, {slides ? Quantity::mass : Quantity::inertia, 0}, 0.5, draw);
  const Sampling sampled = sampling(rig.rate, 3.0, 30.0, 40.0, 400.0, draw);
  rig.interval = sampled.interval;
  rig.trials = empty_trials(sampled.samples, 1, draw);
  for (TrialPlan& trial : rig.trials) {
    const Wave kind = draw.chance(0.6) ? Wave::sine : Wave::multisine;
    trial.reference = {wave(kind, trial.samples, rig.interval, 0.5 * rig.rate, 1.5 * rig.rate, draw)};
    const double own = reach * draw.between(0.5, 1.0);
    for (double& value : trial.reference[0]) value *= own;
  }
  rig.longest = rig.interval * static_cast<double>(rig.trials[0].samples);
  rig.noise = draw.log_between(5e-5, 5e-4);
  return rig;
}

}  // namespace hidden_effects::dirty
