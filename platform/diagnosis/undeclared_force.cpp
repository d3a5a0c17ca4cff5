#include "diagnosis/undeclared_force.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kMostOfNoise = 2.0;  ///< variance with random forces over that of sensors alone

double variance(const NoiseModel& noise) {
  double sum = 0.0;
  for (std::size_t k = 0; k < noise.segments(); ++k) sum += noise.covariance(k).trace();
  return sum;
}

bool is_force(const NoiseComponent& one) {
  return one.kind == NoiseComponent::Kind::force || one.kind == NoiseComponent::Kind::slow_force;
}

bool forces_are_most(const NoiseModel& noise) {
  NoiseModel sensors = noise;
  std::vector<double> deviations = noise.deviations();
  for (std::size_t i = 0; i < deviations.size(); ++i)
    if (is_force(noise.components()[i])) deviations[i] = 0.0;
  sensors.set_deviations(deviations);
  return variance(noise) > kMostOfNoise * variance(sensors);
}

/// Of the force that disturbs the motion most: the correlation time with which its deviation has the same power at low
/// frequencies. White forces are pulses of that duration, slow ones are correlated over it.
double correlation_time(const RandomForce& force) {
  return force.duration == kSlowForce ? force.duration : 0.5 * force.duration;
}

double power(const RandomForce& force) { return force.deviation * force.deviation * correlation_time(force); }

}  // namespace

std::string undeclared_force(const Diagnosis& diagnosis, const Contender& contender, const Round& last) {
  const auto most = std::max_element(diagnosis.forces.begin(), diagnosis.forces.end(),
                                     [](const RandomForce& a, const RandomForce& b) { return power(a) < power(b); });
  if (most == diagnosis.forces.end() || !contender.experiment.noise.process.empty() || !forces_are_most(last.noise))
    return "";
  double all = 0.0;
  for (const RandomForce& one : diagnosis.forces)
    if (one.joint == most->joint) all += power(one);
  return fmt::format(
      "most of the noise is a random force on {}, and the experiment declares none: compare, which counts the noise of "
      "sensors alone, puts a right model above the floor; under [noise], process = {{ \"{}\" = \"{:.3g} {}\" }} and "
      "process_correlation_time = \"{:.3g} s\" declare about as much",
      most->joint, most->joint, std::sqrt(all / correlation_time(*most)), most->unit, correlation_time(*most));
}

}  // namespace lacuna
