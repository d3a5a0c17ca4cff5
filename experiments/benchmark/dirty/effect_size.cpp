#include "dirty/effect_size.h"

#include "cases/scales_of.h"
#include "dirty/rig_parts.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hidden_effects::dirty {
namespace {

constexpr double kMostSteps = 40000.0;  ///< of a short trial, on one joint
constexpr double kLeastSize = 1e-4, kClose = 0.2;
constexpr int kMostTries = 7;

DirtyRig shortened(DirtyRig rig) {
  const double joints = static_cast<double>(rig.stated.joints.size());
  const auto most = static_cast<std::size_t>(kMostSteps / joints / steps_a_sample(rig, 1));
  const auto needed = static_cast<std::size_t>(1.2 * rig.longest / rig.interval) + 20;
  for (TrialPlan& trial : rig.trials) {
    trial.samples = std::min(trial.samples, std::max({most, needed, std::size_t{60}}));
    for (std::vector<double>& one : trial.reference) one.resize(trial.samples);
  }
  if (rig.trials.size() > 2) rig.trials.resize(2);
  rig.trials.front().held_out = false;
  return rig;
}

double range_of(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *most - *least;
}

double rms_slope(const DenseReadings& dense) {
  double sum = 0.0;
  for (std::size_t k = 1; k < dense.values.size(); ++k)
    sum += std::pow((dense.values[k] - dense.values[k - 1]) / dense.interval, 2);
  return std::sqrt(sum / static_cast<double>(dense.values.size() - 1));
}

}  // namespace

SizingBench::SizingBench(const DirtyRig& rig, const PlantSpec& truth, std::uint64_t seed, bool worst)
    : rig_(shortened(rig)), true_spec_(truth), seed_(seed), worst_(worst) {
  noise_.assign(rig.stated.sensors.size(), 0.0);
  const Truth plain{true_spec_, {}, 1};
  plain_ = carry_out_all(plain);
  for (std::size_t s = 0; s < noise_.size(); ++s) {
    double range = 0.0, speed = 0.0;
    for (const TrueTrial& trial : plain_) {
      const DenseReadings dense = read_densely(true_spec_, {}, trial, s);
      range = std::max(range, range_of(dense.values));
      if (true_spec_.sensors[s].velocity)
        range = std::max(range, *std::max_element(dense.values.begin(), dense.values.end()));
      speed = std::max(speed, rms_slope(dense));
    }
    if (!trial_is_force(s))
      range_.push_back(range);
    else
      range_.push_back(std::max(range, rig.force));
    speed_.push_back(speed);
    if (!(range_.back() > 0.0)) throw std::runtime_error("a sensor that never moves");
  }
}

bool SizingBench::trial_is_force(std::size_t sensor) const { return rig_.driving == Driving::imposed && sensor == 1; }

std::vector<TrueTrial> SizingBench::carry_out_all(const Truth& truth) const {
  std::vector<TrueTrial> trials;
  for (std::size_t t = 0; t < rig_.trials.size(); ++t)
    trials.push_back(carry_out(rig_, truth, rig_.trials[t], noise_, mixed(seed_, 40 + t)));
  return trials;
}

Scales SizingBench::scales(const PlacedKind& placed) const {
  std::vector<Excitation> excitations;
  std::vector<Motion> motions;
  for (const TrueTrial& trial : plain_) {
    excitations.push_back(trial.applied);
    if (excitations.back().commands.empty()) excitations.back().commands = {{0.0, 0.0}};
    motions.push_back(trial.motion);
  }
  PlantSpec spec = true_spec_;
  if (rig_.driving == Driving::imposed) spec.drives.clear();
  Scales at = scales_of(spec, placed.kind->law.place, placed.element, excitations, motions);
  at.duration = rig_.interval * static_cast<double>(rig_.trials.front().samples);
  for (const PlantDrive& drive : spec.drives)
    if (drive.resistance > 0.0) at.force *= drive.torque_constant / drive.resistance;
  for (const PlantDrive& drive : spec.drives)
    if (drive.resistance > 0.0) at.peak_force *= drive.torque_constant / drive.resistance;
  if (rig_.driving == Driving::servo || rig_.driving == Driving::position_loop) {
    // Gears rub by what they carry, not only by what they accelerate.
    const int joint = joint_of(spec, placed.kind->law.place, placed.element);
    at.force = std::max(at.force, 0.3 * std::abs(gravity_stiffness(spec, joint)));
    at.peak_force = std::max(at.peak_force, at.force);
  }
  if (rig_.force > 0.0) at.force = at.peak_force = rig_.force;
  if (rig_.driving == Driving::imposed && placed.kind->law.place == Place::sensor) at.position = range_[1];
  return at;
}

DirtyEffect SizingBench::sized(const PlacedKind& placed, const Shape& shape, double size) const {
  DirtyEffect effect;
  effect.kind = placed.kind;
  effect.element = placed.element;
  effect.shape = shape;
  effect.size = size;
  effect.parameters = placed.kind->law.at_size(size, scales(placed), shape);
  effect.law = placed.kind->law.make(effect.parameters, placed.element);
  return effect;
}

Truth SizingBench::truth_with(const std::vector<DirtyEffect>& effects) const {
  Truth truth{true_spec_, {}, 1};
  for (const DirtyEffect& effect : effects) {
    if (!effect.kind) {
      effect.value.in(truth.spec) *= effect.factor;
      continue;
    }
    truth.laws.push_back(effect.law);
    truth.finer = std::max(truth.finer, effect.kind->finer);
  }
  return truth;
}

double SizingBench::error(const std::vector<DirtyEffect>& effects) const {
  const Truth truth = truth_with(effects);
  try {
    const std::vector<TrueTrial> trials = carry_out_all(truth);
    const OwnerError error(rig_, truth, trials, noise_, {.most_steps = 2000.0, .most_refits = 3, .worst = worst_});
    return error.of({rig_.stated, {}, {}, 1}, clean_readings(truth, trials));
  } catch (const std::runtime_error&) {
    return 1e6;
  }
}

DirtyEffect sized_for(const SizingBench& bench, const PlacedKind& placed, const Shape& shape, double wanted,
                      double enough, double& reached) {
  const double most = placed.kind->most_size;
  double low = kLeastSize, high = most, size = 1.0;
  DirtyEffect best;
  double best_miss = 1e9;
  for (int i = 0; i < kMostTries; ++i) {
    DirtyEffect tried = bench.sized(placed, shape, size);
    const double left = bench.error({tried});
    const double miss = std::abs(std::log(std::max(left, 1e-9) / wanted));
    if (miss < best_miss) best = std::move(tried), best_miss = miss, reached = left;
    if (miss < kClose || 2.0 * most / size * left < enough) break;
    (left < wanted ? low : high) = size;
    // What is left grows about in proportion to the size; halve the logarithmic interval where that leads out of it.
    const double next = size * std::clamp(wanted / std::max(left, 1e-9), 0.01, 100.0);
    size = next > low * 1.02 && next < high / 1.02 ? next : std::sqrt(low * high);
    if (high / low < 1.05) break;
  }
  return best;
}

}  // namespace hidden_effects::dirty
