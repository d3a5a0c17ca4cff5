#include "dirty/rig_parts.h"

#include "plant/chain.h"
#include "plant/coordinates.h"

#include <algorithm>

namespace hidden_effects::dirty {
namespace {

std::vector<double> multisine(std::size_t samples, double interval, double slowest, double fastest, RigDraw& draw) {
  constexpr int kTones = 7;
  double rate[kTones], phase[kTones];
  for (int k = 0; k < kTones; ++k) {
    rate[k] = slowest * std::pow(fastest / slowest, (k + draw.uniform()) / kTones);
    phase[k] = kTurn * draw.uniform();
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < samples; ++i) {
    double sum = 0.0;
    for (int k = 0; k < kTones; ++k) sum += std::sin(rate[k] * static_cast<double>(i) * interval + phase[k]);
    values.push_back(sum / std::sqrt(1.0 * kTones));
  }
  return values;
}

std::vector<double> steps(std::size_t samples, double interval, double slowest, double fastest, RigDraw& draw) {
  std::vector<double> values;
  double sign = draw.sign();
  while (values.size() < samples) {
    const double period = kTurn / draw.log_between(slowest, fastest);
    const auto held = std::max<std::size_t>(2, static_cast<std::size_t>(0.5 * period / interval));
    values.insert(values.end(), held, sign * draw.between(0.3, 1.4));
    sign = draw.chance(0.75) ? -sign : sign;
  }
  values.resize(samples);
  return values;
}

double triangle_at(double turns) { return 4.0 * std::abs(turns - std::floor(turns) - 0.5) - 1.0; }

std::vector<double> periodic(Wave kind, std::size_t samples, double interval, double slowest, double fastest,
                             RigDraw& draw) {
  const double phase = draw.uniform(), duration = static_cast<double>(samples) * interval;
  const double rate = std::sqrt(slowest * fastest) / kTurn;
  std::vector<double> values;
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) * interval;
    const double swept = (slowest + 0.5 * (fastest - slowest) * t / duration) * t / kTurn;
    if (kind == Wave::triangle) values.push_back(1.4 * triangle_at(phase + rate * t));
    if (kind == Wave::sine) values.push_back(std::numbers::sqrt2 * std::sin(kTurn * (phase + rate * t)));
    if (kind == Wave::chirp) values.push_back(std::numbers::sqrt2 * std::sin(kTurn * (phase + swept)));
  }
  return values;
}

}  // namespace

double length_for(double mass, RigDraw& draw) { return 0.15 * std::cbrt(mass) * draw.log_between(0.6, 2.5); }

Sampling sampling(double rate, double least_periods, double most_periods, double least_samples, double most_samples,
                  RigDraw& draw) {
  const double period = kTurn / rate;
  const double duration = std::min(kLongest, period * draw.log_between(least_periods, most_periods));
  const double wanted = draw.log_between(least_samples, most_samples) / period;
  const double frequency = std::clamp(wanted, std::max(kSlowest, kFewestSamples / duration), kFastest);
  // Loggers run at rates that one can say: two digits.
  const double size = std::pow(10.0, std::floor(std::log10(frequency)) - 1.0);
  const double said = std::clamp(std::round(frequency / size) * size, kSlowest, kFastest);
  const auto samples = static_cast<std::size_t>(duration * said);
  return {1.0 / said, std::clamp(samples, kFewestSamples, kMostSamples)};
}

std::vector<TrialPlan> empty_trials(std::size_t samples, std::size_t joints, RigDraw& draw) {
  const std::size_t files = 1 + draw.below(3);
  std::vector<TrialPlan> trials(files);
  const auto n = static_cast<Eigen::Index>(joints);
  for (std::size_t t = 0; t < files; ++t) {
    trials[t].name = "run" + std::to_string(t + 1);
    trials[t].held_out = files > 1 && t + 1 == files;
    trials[t].samples = std::max(kFewestSamples, static_cast<std::size_t>(static_cast<double>(samples) *
                                                                          (t == 0 ? 1.0 : draw.between(0.6, 1.0))));
    trials[t].start = {Coordinates::Zero(n), Coordinates::Zero(n)};
  }
  return trials;
}

std::vector<double> wave(Wave kind, std::size_t samples, double interval, double slowest, double fastest,
                         RigDraw& draw) {
  std::vector<double> values;
  if (kind == Wave::multisine) values = multisine(samples, interval, slowest, fastest, draw);
  if (kind == Wave::steps) values = steps(samples, interval, slowest, fastest, draw);
  if (values.empty()) values = periodic(kind, samples, interval, slowest, fastest, draw);
  const double rise = 1.0 / slowest;  // s
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) * interval / rise - 0.2;
    values[i] *= t <= 0.0 ? 0.0 : t >= 1.0 ? 1.0 : 0.5 - 0.5 * std::cos(std::numbers::pi * t);
  }
  return values;
}

Wave any_wave(RigDraw& draw) { return static_cast<Wave>(draw.below(5)); }

PlantBody hanging(const std::string& name, double mass, double lever, double share) {
  return {name, mass, {0.0, lever}, share * mass * lever * lever};
}

void fit_or_state(DirtyRig& rig, RobotValue value, double share, RigDraw& draw) {
  if (!draw.chance(share)) {
    rig.fixed.push_back(value);
    return;
  }
  const bool damps = value.quantity == Quantity::damping || value.quantity == Quantity::kd;
  if (damps)
    rig.free.push_back({value, 0.4, 0.0, 10.0});
  else
    rig.free.push_back({value, 0.15, 0.2, 5.0});
}

double inertia_at(const PlantSpec& spec, int joint) {
  const auto n = static_cast<Eigen::Index>(spec.joints.size());
  Chain chain(spec);
  chain.move_to(Coordinates::Zero(n), Coordinates::Zero(n));
  CoordinateMatrix inertia = CoordinateMatrix::Zero(n, n);
  Coordinates force = Coordinates::Zero(n);
  chain.add_inertia(inertia, force);
  double sum = inertia(joint, joint) + spec.joints[static_cast<std::size_t>(joint)].armature;
  for (const PlantDrive& drive : spec.drives)
    if (drive.joint == joint) sum += drive.rotor_inertia;
  return sum;
}

double gravity_stiffness(const PlantSpec& spec, int joint) {
  constexpr double kTurned = 1e-4;  // rad
  const auto n = static_cast<Eigen::Index>(spec.joints.size());
  const auto torque = [&](double angle) {
    Chain chain(spec);
    Coordinates position = Coordinates::Zero(n);
    position[joint] = angle;
    chain.move_to(position, Coordinates::Zero(n));
    CoordinateMatrix inertia = CoordinateMatrix::Zero(n, n);
    Coordinates force = Coordinates::Zero(n);
    chain.add_inertia(inertia, force);
    return force[joint];
  };
  return -(torque(kTurned) - torque(-kTurned)) / (2.0 * kTurned);
}

void maybe_damp(DirtyRig& rig, int joint, double ratio, RigDraw& draw) {
  if (draw.chance(0.5)) damp(rig, joint, ratio, draw);
}

void damp(DirtyRig& rig, int joint, double ratio, RigDraw& draw) {
  rig.stated.joints[static_cast<std::size_t>(joint)].damping = 2.0 * ratio * rig.rate * inertia_at(rig.stated, joint);
  fit_or_state(rig, {Quantity::damping, joint}, 0.7, draw);
}

}  // namespace hidden_effects::dirty
