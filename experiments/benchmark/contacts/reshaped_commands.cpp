#include "contacts/reshaped_commands.h"

#include "plant/draw.h"

#include <algorithm>
#include <cmath>

namespace hidden_effects {
namespace {

std::vector<double> held_finely(const std::vector<double>& values) {
  std::vector<double> fine;
  for (const double value : values) fine.insert(fine.end(), kFiner, value);
  return fine;
}

void jitter(std::vector<double>& values, double delay, double interval, std::uint64_t seed) {
  Draw draw(seed, 1);
  const std::vector<double> prompt = values;
  double behind = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (k % kFiner == 0) behind = delay * draw.between(0.5, 1.5);
    const auto steps = static_cast<std::size_t>(std::lround(behind / interval));
    values[k] = prompt[k - std::min(k, steps)];
  }
}

void lag(std::vector<double>& values, double time, double interval) {
  const double share = -std::expm1(-interval / time);
  double out = values.front();
  for (double& value : values) value = out += share * (value - out);
}

bool acts_on(const ContactLaw& law, const ContactDrive& drive) {
  return law.where == "actuator.*" || law.where == "actuator." + drive.name;
}

}  // namespace

Samples reshaped_commands(const ContactRig& rig, const std::vector<SizedContactLaw>& laws, const Samples& commands,
                          std::uint64_t seed) {
  const double interval = rig.interval / kFiner;
  Samples all;
  for (std::size_t d = 0; d < commands.size(); ++d) {
    std::vector<double>& values = all.emplace_back(held_finely(commands[d]));
    for (const SizedContactLaw& one : laws) {
      if (!acts_on(one.law, rig.drives[d])) continue;
      if (one.law.name == "jittered_delay") jitter(values, one.value, interval, mixed(seed, d));
      if (one.law.name == "two_stage_lag")
        for (int stage = 0; stage < 2; ++stage) lag(values, 0.5 * one.value, interval);
    }
  }
  return all;
}

}  // namespace hidden_effects
