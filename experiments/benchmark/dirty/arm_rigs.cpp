#include "dirty/rig_parts.h"

#include <algorithm>

/// Arms of two, three and six joints in a vertical plane.
namespace hidden_effects::dirty {
namespace {

const char* const kLinks[] = {"shoulder", "upper", "fore", "wrist", "hand", "tool"};

/// Links one behind the other, each lighter and shorter than the one before. `up`: zero is upright, else hanging.
void build_links(DirtyRig& rig, std::size_t count, double mass, bool up, RigDraw& draw) {
  double length = 1.6 * length_for(mass, draw);
  double reach = 0.0;
  for (std::size_t j = 0; j < count; ++j) {
    const double sign = up ? 1.0 : -1.0;
    const std::string name = count == 2 ? (j == 0 ? "upper" : "lower") : kLinks[j];
    rig.stated.bodies.push_back(hanging(name, mass, sign * draw.between(0.4, 0.6) * length, draw.between(0.25, 0.5)));
    rig.stated.joints.push_back({.name = name + "_joint", .anchor = {0.0, sign * reach}});
    rig.stated.sensors.push_back({name + "_angle", static_cast<int>(j)});
    reach = length;
    length *= draw.between(0.65, 0.95);
    mass *= draw.between(0.45, 0.8);
  }
}

/// The rotor of each motor is a good part of what it moves, as behind a gear.
void build_drives(DirtyRig& rig, bool servo, double least_rotor, double most_rotor, RigDraw& draw) {
  for (std::size_t j = 0; j < rig.stated.joints.size(); ++j) {
    const double rotor = draw.between(least_rotor, most_rotor) * inertia_at(rig.stated, static_cast<int>(j));
    rig.stated.drives.push_back({.name = rig.stated.bodies[j].name + (servo ? "_servo" : "_motor"),
                                 .joint = static_cast<int>(j),
                                 .servo = servo,
                                 .rotor_inertia = rotor});
  }
}

/// The torque of a link's weight at its joint where the arm is stretched out: N·m.
double weight_at(const PlantSpec& spec, std::size_t joint) {
  return std::abs(gravity_stiffness(spec, static_cast<int>(joint)));
}

/// Gains of each joint's loop, in the drives of servos or in a controller outside.
void close_loops(DirtyRig& rig, double stiffer, bool integral, RigDraw& draw) {
  for (std::size_t j = 0; j < rig.stated.joints.size(); ++j) {
    const double inertia = inertia_at(rig.stated, static_cast<int>(j));
    const double kp = stiffer * weight_at(rig.stated, j) * draw.between(0.8, 1.6);
    const double rate = std::sqrt(kp / inertia), kd = 2.0 * draw.between(0.5, 0.9) * inertia * rate;
    rig.fastest = std::max(rig.fastest, 2.0 * rate);
    if (rig.driving == Driving::servo)
      rig.stated.drives[j].kp = kp, rig.stated.drives[j].kd = kd;
    else
      rig.loops.push_back({.proportional = kp, .derivative = kd, .integral = integral ? 0.3 * kp * rate : 0.0});
  }
}

void sample_arm(DirtyRig& rig, double least, double most, double least_duration, double most_duration, RigDraw& draw) {
  const double frequency = std::round(draw.log_between(least, most) / 5.0) * 5.0;
  rig.interval = 1.0 / frequency;
  const auto samples = static_cast<std::size_t>(draw.log_between(least_duration, most_duration) * frequency);
  rig.trials = empty_trials(std::min(samples, kMostSamples), rig.stated.joints.size(), draw);
}

void wave_each(DirtyRig& rig, const std::vector<double>& sizes, RigDraw& draw) {
  for (TrialPlan& trial : rig.trials)
    for (std::size_t d = 0; d < rig.stated.drives.size(); ++d) {
      trial.reference.push_back(
          wave(any_wave(draw), trial.samples, rig.interval, 0.15 * rig.rate, 1.2 * rig.rate, draw));
      const double own = sizes[d] * draw.between(0.6, 1.2);
      for (double& value : trial.reference.back()) value *= own;
    }
}

double slowest_rate(const DirtyRig& rig) {
  double slowest = 1e9;
  for (std::size_t j = 0; j < rig.stated.joints.size(); ++j)
    slowest = std::min(slowest, std::sqrt(weight_at(rig.stated, j) / inertia_at(rig.stated, static_cast<int>(j))));
  return slowest;
}

void know_links(DirtyRig& rig, double share, RigDraw& draw) {
  for (int j = 0; j < static_cast<int>(rig.stated.joints.size()); ++j) {
    fit_or_state(rig, {Quantity::mass, j}, share, draw);
    fit_or_state(rig, {Quantity::inertia, j}, 0.5 * share, draw);
    rig.fixed.push_back({Quantity::lever, j});
  }
}

}  // namespace

/// Two links with a motor at each joint: hanging under listed torques, or led by a controller; now and then upright.
DirtyRig two_link_arm(RigDraw& draw) {
  DirtyRig rig;
  const double mass = draw.log_between(0.1, 40.0);
  const bool up = draw.chance(0.35), open = !up && draw.chance(0.5);
  build_links(rig, 2, mass, up, draw);
  build_drives(rig, false, 0.1, 0.4, draw);
  rig.driving = open ? Driving::open_loop : Driving::position_loop;
  rig.rate = slowest_rate(rig);
  rig.fastest = 4.0 * rig.rate;
  if (!open) close_loops(rig, up ? 4.0 : 2.5, draw.chance(0.3), draw);
  for (int j = 0; j < 2; ++j) (open ? damp : maybe_damp)(rig, j, draw.log_between(0.05, 0.2), draw);
  know_links(rig, 0.4, draw);
  for (int d = 0; d < 2; ++d) rig.fixed.push_back({Quantity::gain, d});
  const double least = std::max(60.0, 10.0 * rig.fastest);
  sample_arm(rig, std::min(least, 900.0), std::min(kFastest, 3.0 * std::max(least, 150.0)), 6.0, 30.0, draw);
  std::vector<double> sizes;
  for (std::size_t j = 0; j < 2; ++j)
    sizes.push_back(open ? draw.between(0.2, 0.45) * weight_at(rig.stated, j) : draw.between(0.2, 0.7));
  wave_each(rig, sizes, draw);
  rig.longest = (up ? 1.2 : open ? 0.7 * kTurn : 0.5 * kTurn) / rig.rate;
  rig.noise = draw.log_between(1e-4, 2e-3);
  return rig;
}

/// Three links under a controller whose torques are recorded, or of servos whose goals are.
DirtyRig three_link_arm(RigDraw& draw) {
  DirtyRig rig;
  const bool servo = draw.chance(0.5);
  build_links(rig, 3, draw.log_between(0.1, 30.0), false, draw);
  build_drives(rig, servo, 0.3, 1.2, draw);
  rig.driving = servo ? Driving::servo : Driving::position_loop;
  rig.rate = slowest_rate(rig);
  close_loops(rig, servo ? 6.0 : 3.0, false, draw);
  for (int d = 0; d < 3; ++d) {
    if (servo) fit_or_state(rig, {Quantity::kp, d}, 0.7, draw);
    if (servo) fit_or_state(rig, {Quantity::kd, d}, 0.3, draw);
    if (!servo) rig.fixed.push_back({Quantity::gain, d});
    maybe_damp(rig, d, draw.log_between(0.05, 0.2), draw);
  }
  know_links(rig, servo ? 0.0 : 0.3, draw);
  const double least = servo ? 40.0 : std::clamp(10.0 * rig.fastest, 100.0, 1000.0);
  sample_arm(rig, least, 2.0 * least, 8.0, 40.0, draw);
  wave_each(rig, {draw.between(0.2, 0.6), draw.between(0.2, 0.6), draw.between(0.2, 0.7)}, draw);
  rig.longest = kTurn / rig.rate;
  rig.noise = draw.log_between(2e-4, 2e-3);
  return rig;
}

/// Six servos one behind the other, their goals recorded.
DirtyRig six_joint_arm(RigDraw& draw) {
  DirtyRig rig;
  build_links(rig, 6, draw.log_between(0.15, 12.0), false, draw);
  build_drives(rig, true, 0.5, 2.0, draw);
  rig.driving = Driving::servo;
  rig.rate = slowest_rate(rig);
  close_loops(rig, 8.0, false, draw);
  for (int d = 0; d < 6; ++d) fit_or_state(rig, {Quantity::kp, d}, 0.6, draw);
  for (int j = 0; j < 6; ++j) rig.fixed.push_back({Quantity::mass, j});
  sample_arm(rig, 40.0, 100.0, 8.0, 60.0, draw);
  wave_each(rig, std::vector<double>(6, draw.between(0.2, 0.5)), draw);
  rig.longest = 0.5 * kTurn / rig.rate;
  rig.noise = draw.log_between(3e-4, 2e-3);
  return rig;
}

}  // namespace hidden_effects::dirty
