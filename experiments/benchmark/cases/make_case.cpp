#include "cases/make_case.h"

#include "cases/recorded_trial.h"
#include "cases/scales_of.h"
#include "cases/strength.h"
#include "plant/draw.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hidden_effects {
namespace {

constexpr int kFitTrials = 3, kTrials = 4;
constexpr std::array kNames = {"multisine", "steps", "chirp", "triangle"};

enum Stream : std::uint64_t { kTrueValues = 1, kShapes = 2, kCommands = 10, kNoise = 50 };

PlantModel base_model(const CasePlan& plan, const Rig& rig) {
  PlantModel model{rig.nominal, {}, {}};
  for (const FreeValue& value : rig.free)
    if (std::find(plan.known.begin(), plan.known.end(), value.address) == plan.known.end()) model.free.push_back(value);
  return model;
}

Eigen::VectorXd draw_base_values(const PlantModel& base, Draw draw) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(base.free.size()));
  PlantSpec spec = base.spec;
  for (std::size_t i = 0; i < base.free.size(); ++i) {
    const FreeValue& value = base.free[i];
    values[static_cast<Eigen::Index>(i)] = value.of(spec) * (1.0 + value.spread * draw.between(-1.0, 1.0));
  }
  return values;
}

/// A bench's sensors and what disturbs it, at a level of noise.
CaseNoise noise_of(const CasePlan& plan, const Rig& rig, const std::vector<Scales>& of_joints) {
  CaseNoise noise;
  const std::size_t sensors = rig.nominal.sensors.size();
  const bool white = plan.noise == NoiseLevel::white, disturbed = plan.noise == NoiseLevel::disturbed;
  for (std::size_t s = 0; s < sensors; ++s) {
    noise.sensor_white.push_back(rig.scales.sensor_noise[s] * (white ? 1.0 : 0.5));
    noise.sensor_slow.push_back(white ? 0.0 : rig.scales.sensor_noise[s] * 0.7);
    noise.quantum.push_back(white ? 0.0 : rig.scales.quantum[s]);
  }
  for (const Scales& at : of_joints) noise.random_force.push_back(disturbed ? rig.scales.random_force * at.force : 0.0);
  for (std::size_t d = 0; d < rig.nominal.drives.size(); ++d)
    noise.command.push_back(disturbed ? rig.scales.command_noise * rig.scales.amplitude[d] : 0.0);
  return noise;
}

Excitation excitation_of(const Rig& rig, int trial, const CasePlan& plan) {
  Excitation excitation;
  excitation.interval = rig.interval;
  excitation.commands =
      commands(rig, trial, plan.duration, mixed(plan.seed, kCommands + static_cast<std::uint64_t>(trial)));
  return excitation;
}

Start at_zero(const PlantSpec& spec) {
  const auto n = static_cast<Eigen::Index>(spec.joints.size());
  return {Coordinates::Zero(n), Coordinates::Zero(n)};
}

class Maker {
 public:
  explicit Maker(const CasePlan& plan) : rig_(rig_named(plan.rig)) {
    made_.plan = plan;
    made_.base = base_model(plan, rig_);
    made_.base_values = draw_base_values(made_.base, Draw(plan.seed, kTrueValues));
    for (int t = 0; t < kTrials; ++t) excitations_.push_back(excitation_of(rig_, t, plan));
    look_at_motion();
    made_.truth = made_.base;
    for (const HiddenLaw& hidden : plan.hidden) made_.truth.laws.push_back({&law_kind(hidden.law), hidden.element});
  }

  MadeCase run() {
    choose_sizes();
    for (int t = 0; t < kTrials; ++t) record(t);
    measure_strength(made_);
    return std::move(made_);
  }

 private:
  /// The motion of a plant that hides nothing: what sizes are told by.
  void look_at_motion() {
    for (Excitation& excitation : excitations_) {
      Simulation plant(made_.base.spec_at(made_.base_values), {}, excitation, kFitStep);
      motions_.push_back(simulate(plant, at_zero(made_.base.spec), excitation.samples(), 1));
    }
    std::vector<Scales> of_joints;
    for (int j = 0; j < elements_of(rig_.nominal, Place::joint); ++j)
      of_joints.push_back(scales_of(rig_.nominal, Place::joint, j, excitations_, motions_));
    made_.noise = noise_of(made_.plan, rig_, of_joints);
  }

  /// Each law is sized for itself, with what the others share of the strength taken off where there are two.
  void choose_sizes() {
    made_.truth_values = made_.base_values;
    const double laws = static_cast<double>(made_.truth.laws.size());
    for (std::size_t l = 0; l < made_.truth.laws.size(); ++l) {
      const PlacedLaw& law = made_.truth.laws[l];
      const Scales scales = scales_of(rig_.nominal, law.kind->place, law.element, excitations_, motions_);
      Shape shape;
      Draw draw(made_.plan.seed, kShapes + 1000 * l);
      for (double& number : shape) number = draw.uniform();
      const SizedLaw task{made_, law, scales, shape, fit_excitations(), noisy_excitations()};
      const std::vector<double> parameters =
          parameters_of_strength(task, std::sqrt((made_.plan.strength * made_.plan.strength - 1.0) / laws));
      const Eigen::Index before = made_.truth_values.size();
      made_.truth_values.conservativeResize(before + static_cast<Eigen::Index>(parameters.size()));
      for (std::size_t i = 0; i < parameters.size(); ++i)
        made_.truth_values[before + static_cast<Eigen::Index>(i)] = parameters[i];
    }
  }

  std::vector<Excitation> fit_excitations() const { return {excitations_.begin(), excitations_.begin() + kFitTrials}; }

  std::vector<Excitation> noisy_excitations() const {
    std::vector<Excitation> noisy = fit_excitations();
    for (std::size_t t = 0; t < noisy.size(); ++t) add_random_forces(noisy[t], made_.noise, noise_seed(t));
    return noisy;
  }

  std::uint64_t noise_seed(std::size_t trial) const { return mixed(made_.plan.seed, kNoise + trial); }

  void record(int t) {
    const auto number = static_cast<std::size_t>(t);
    MadeTrial trial = recorded_trial(made_, excitations_[number], noise_seed(number));
    trial.name = kNames[number];
    trial.held_out = t >= kFitTrials;
    made_.trials.push_back(std::move(trial));
  }

  const Rig& rig_;
  MadeCase made_;
  std::vector<Excitation> excitations_;
  std::vector<Motion> motions_;
};

}  // namespace

FittedTrial MadeTrial::fitted() const {
  Excitation excitation = applied;
  excitation.forces.clear();
  excitation.commands = recorded_commands;
  return {std::move(excitation), readings};
}

FittedTrial MadeTrial::noise_free() const {
  Excitation excitation = applied;
  excitation.forces.clear();
  return {std::move(excitation), clean};
}

MadeCase make_case(const CasePlan& plan) { return Maker(plan).run(); }

}  // namespace hidden_effects
