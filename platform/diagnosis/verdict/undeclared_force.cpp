#include "diagnosis/verdict/undeclared_force.h"

#include "diagnosis/residual_force/random_force.h"
#include "diagnosis/rounds/channel_errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lacuna {
namespace {

constexpr double kMostOfNoise = 0.5;     ///< of the noise's variance, by all forces
constexpr double kWorthDeclaring = 0.1;  ///< of that of all forces, by one joint's

/// Of what such noise leaves once the starts are fitted, in multiples of that of the sensors: sum over the channels.
double variance_of(const NoiseModel& noise, const Round& last) {
  double sum = 0.0;
  for (const ChannelError& channel : channel_errors(last.base, last.bins, noise, last.fit, last.folds)) {
    const auto sensor = std::find_if(last.base.noise.begin(), last.base.noise.end(),
                                     [&](const ChannelNoise& one) { return one.channel == channel.channel; });
    sum += std::pow(channel.floor / sensor->deviation, 2);
  }
  return sum;
}

/// Of the readings, by the forces on each joint.
std::vector<double> variances_by_joint(const Round& last) {
  std::vector<double> variances;
  const double all = variance_of(last.noise, last);
  for (std::size_t joint = 0; joint < last.forces.joints.size(); ++joint) {
    std::vector<double> deviations = last.noise.deviations();
    for (std::size_t i = 0; i < deviations.size(); ++i) {
      const NoiseComponent& one = last.noise.components()[i];
      const bool is_force = one.kind == NoiseComponent::Kind::force || one.kind == NoiseComponent::Kind::slow_force;
      if (is_force && one.index == joint) deviations[i] = 0.0;
    }
    NoiseModel others = last.noise;
    others.set_deviations(deviations);
    variances.push_back(all - variance_of(others, last));
  }
  return variances;
}

/// The joints whose random forces are noticeable, the one that disturbs the readings most first; none where all forces
/// together are not most of the noise.
std::vector<std::string> joints_to_declare(const Round& last) {
  const std::vector<double> variances = variances_by_joint(last);
  double by_forces = 0.0;
  for (const double one : variances) by_forces += one;
  std::vector<std::size_t> order;
  for (std::size_t joint = 0; joint < variances.size(); ++joint)
    if (variances[joint] > kWorthDeclaring * by_forces) order.push_back(joint);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return variances[a] > variances[b]; });
  std::vector<std::string> names;
  if (by_forces <= kMostOfNoise * variance_of(last.noise, last)) return names;
  for (const std::size_t joint : order) names.push_back("joint." + last.forces.joints[joint]);
  return names;
}

std::vector<RandomForce> forces_on(const std::string& joint, const std::vector<RandomForce>& forces) {
  std::vector<RandomForce> own;
  std::copy_if(forces.begin(), forces.end(), std::back_inserter(own),
               [&](const RandomForce& force) { return force.joint == joint; });
  return own;
}

/// Of the force on a joint that has most power.
double correlation_time_of(const std::vector<RandomForce>& own) {
  return correlation_time(*std::max_element(
      own.begin(), own.end(), [](const RandomForce& a, const RandomForce& b) { return power(a) < power(b); }));
}

/// The deviation of one force with that correlation time that has the power of all.
double deviation_of(const std::vector<RandomForce>& own, double time) {
  double all = 0.0;
  for (const RandomForce& force : own) all += power(force);
  return std::sqrt(all / time);
}

}  // namespace

std::string undeclared_force(const Diagnosis& diagnosis, const Contender& contender, const Round& last) {
  if (!contender.experiment.noise.process.empty() || diagnosis.forces.empty()) return "";
  double time = 0.0;
  std::vector<std::string> names, entries;
  for (const std::string& joint : joints_to_declare(last)) {
    const std::vector<RandomForce> own = forces_on(joint, diagnosis.forces);
    if (own.empty()) continue;
    if (names.empty()) time = correlation_time_of(own);  // the experiment has one for all
    names.push_back(joint);
    entries.push_back(fmt::format("\"{}\" = \"{:.3g} {}\"", joint, deviation_of(own, time), own.front().unit));
  }
  if (names.empty()) return "";
  return fmt::format(
      "most of the noise is a random force on {}, and the experiment declares none: compare, which counts the noise of "
      "sensors alone, puts a right model above the floor; under [noise], process = {{ {} }} and "
      "process_correlation_time = \"{:.3g} s\" declare about as much",
      fmt::join(names, " and "), fmt::join(entries, ", "), time);
}

}  // namespace lacuna
