#include "contacts/contact_recording.h"

#include "contacts/hopper_plant.h"
#include "contacts/reshaped_commands.h"
#include "plant/draw.h"

#include <cmath>

namespace hidden_effects {
namespace {

constexpr double kWhiteShare = 0.5, kSlowShare = 0.7;    ///< of a channel's noise, where it is coloured
constexpr double kSensorTime = 0.03, kForceTime = 0.05;  ///< s, of slow noise

enum Stream : std::uint64_t { kCommands = 1, kShapes = 2, kForces = 100, kRecorder = 200, kWhite = 300, kSlow = 400 };

void add_random_force(Samples& applied, const ContactRig& rig, std::uint64_t seed) {
  for (std::size_t d = 0; d < applied.size(); ++d) {
    bench::Disturbance force(rig.drives[d].random_command, kForceTime, rig.interval, mixed(seed, kForces + d));
    for (double& value : applied[d]) {
      value += force.value();
      force.next();
    }
  }
}

void add_command_noise(Samples& recorded, const ContactRig& rig, std::uint64_t seed) {
  for (std::size_t d = 0; d < recorded.size(); ++d) {
    bench::Normal normal(mixed(seed, kRecorder + d));
    for (double& value : recorded[d]) value += rig.drives[d].command_noise * normal();
  }
}

void add_sensor_noise(Samples& readings, const ContactRig& rig, bool white_only, std::uint64_t seed) {
  for (std::size_t c = 0; c < readings.size(); ++c) {
    const ContactChannel& channel = rig.channels[c];
    if (channel.touch()) continue;
    bench::Normal white(mixed(seed, kWhite + c));
    bench::Disturbance slow(channel.noise * kSlowShare, kSensorTime, rig.interval, mixed(seed, kSlow + c));
    for (double& value : readings[c]) {
      value += channel.noise * (white_only ? 1.0 : kWhiteShare) * white();
      if (white_only) continue;
      value = bench::rounded(value + slow.value(), channel.quantum);
      slow.next();
    }
  }
}

/// The laws that the engine has.
std::vector<SizedContactLaw> in_library_form(const std::vector<SizedContactLaw>& laws) {
  std::vector<SizedContactLaw> kept;
  for (const SizedContactLaw& one : laws)
    if (one.law.library_form()) kept.push_back(one);
  return kept;
}

}  // namespace

ContactBench::ContactBench(const ContactRig& rig, const std::filesystem::path& folder,
                           std::vector<SizedContactLaw> laws, double free_value, NoiseLevel noise, std::uint64_t seed)
    : rig_(rig), laws_(std::move(laws)), free_value_(free_value), noise_(noise), seed_(seed) {
  if (rig.name != "hopper") engine_.emplace(rig, folder, Integration::truth, in_library_form(laws_));
}

Samples ContactBench::true_readings(const Samples& applied, double interval) const {
  if (engine_) return engine_->readings(free_value_, applied, interval);
  return hopper_readings(hopper_truth(laws_, free_value_), applied.front(), interval, rig_.interval, rig_.samples());
}

ContactTrial ContactBench::record(int number) const {
  const std::uint64_t seed = mixed(seed_, 1000 + static_cast<std::uint64_t>(number));
  ContactTrial trial;
  trial.name = "trial_" + std::to_string(number);
  trial.held_out = number >= rig_.fit_trials;
  trial.commands = rig_.commands(rig_.samples(), mixed(seed, kCommands));
  Samples applied = trial.commands;
  if (noise_ == NoiseLevel::disturbed) {
    add_random_force(applied, rig_, seed);
    add_command_noise(trial.commands, rig_, seed);
  }
  const Samples reshaped = reshaped_commands(rig_, laws_, applied, mixed(seed, kShapes));
  trial.readings = true_readings(reshaped, rig_.interval / kFiner);
  add_sensor_noise(trial.readings, rig_, noise_ == NoiseLevel::white, seed);
  return trial;
}

double deviation(const ContactChannel& channel, NoiseLevel noise) {
  if (noise == NoiseLevel::white) return channel.noise;
  return std::hypot(kWhiteShare * channel.noise, kSlowShare * channel.noise, channel.quantum / std::sqrt(12.0));
}

}  // namespace hidden_effects
