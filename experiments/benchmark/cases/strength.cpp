#include "cases/strength.h"

#include "plant/draw.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hidden_effects {
namespace {

constexpr double kSmallest = 1e-3, kLargest = 10.0;  ///< sizes that are tried
constexpr int kMostTries = 9;
constexpr double kClose = 0.05;     ///< of the wanted strength
constexpr double kAbsorbed = 1.05;  ///< a strength below which the base explains what is hidden

Start zero_start(const PlantSpec& spec) {
  const auto n = static_cast<Eigen::Index>(spec.joints.size());
  return {Coordinates::Zero(n), Coordinates::Zero(n)};
}

std::vector<double> rms_by_sensor(const std::vector<Readings>& differences) {
  std::vector<double> sums(differences.front().size(), 0.0);
  double rows = 0.0;
  for (const Readings& trial : differences) {
    for (std::size_t s = 0; s < trial.size(); ++s)
      for (const double value : trial[s]) sums[s] += value * value;
    rows += static_cast<double>(trial.front().size());
  }
  for (double& sum : sums) sum = std::sqrt(sum / rows);
  return sums;
}

Readings difference(const Readings& a, const Readings& b) {
  Readings result = a;
  for (std::size_t s = 0; s < a.size(); ++s)
    for (std::size_t k = 0; k < a[s].size(); ++k) result[s][k] -= b[s][k];
  return result;
}

/// What noise and random forces leave of a right model that hides nothing, by sensor.
std::vector<double> floor_of(const SizedLaw& task) {
  const MadeCase& made = task.made;
  const Start start = zero_start(made.base.spec);
  std::vector<Readings> pushed;
  for (std::size_t t = 0; t < task.excitations.size(); ++t) {
    const Readings clean = predict(made.base, made.base_values, task.excitations[t], start);
    Excitation disturbed = task.disturbed[t];
    for (std::size_t d = 0; d < disturbed.commands.size(); ++d) {
      bench::Normal normal(mixed(made.plan.seed, 900 + 10 * t + d));
      for (double& value : disturbed.commands[d]) value += made.noise.command[d] * normal();
    }
    pushed.push_back(difference(predict(made.base, made.base_values, disturbed, start), clean));
  }
  std::vector<double> floor = rms_by_sensor(pushed);
  for (std::size_t s = 0; s < floor.size(); ++s) {
    const CaseNoise& noise = made.noise;
    floor[s] = std::sqrt(floor[s] * floor[s] + noise.sensor_white[s] * noise.sensor_white[s] +
                         noise.sensor_slow[s] * noise.sensor_slow[s] + noise.quantum[s] * noise.quantum[s] / 12.0);
  }
  return floor;
}

/// Searches a size, on a logarithmic scale, for what the refitted base leaves.
class SizeSearch {
 public:
  explicit SizeSearch(const SizedLaw& task)
      : task_(task), floor_(floor_of(task)), model_(task.made.base), base_values_(task.made.base_values) {
    model_.laws = {task.law};
  }

  std::vector<double> run(double wanted) {
    double low = kSmallest, high = kLargest, size = 1.0;
    double best = size, best_miss = 1e9;
    for (int i = 0; i < kMostTries; ++i) {
      const double left = left_by_base(size);
      const double miss = std::abs(std::log(std::max(left, 1e-9) / wanted));
      if (miss < best_miss) best = size, best_miss = miss;
      if (miss < kClose) break;
      (left < wanted ? low : high) = size;
      // What is left grows about in proportion to the size; halve the logarithmic interval where that leads out of it.
      const double next = size * std::clamp(wanted / std::max(left, 1e-9), 0.02, 50.0);
      size = next > low * 1.02 && next < high / 1.02 ? next : std::sqrt(low * high);
    }
    return parameters(best);
  }

 private:
  std::vector<double> parameters(double size) const { return task_.law.kind->at_size(size, task_.scales, task_.shape); }

  /// A plant that runs away, or sticks so that nothing moves, is beyond any strength.
  double left_by_base(double size) {
    const std::vector<double> own = parameters(size);
    Eigen::VectorXd values(base_values_.size() + static_cast<Eigen::Index>(own.size()));
    values << base_values_, Eigen::Map<const Eigen::VectorXd>(own.data(), static_cast<Eigen::Index>(own.size()));
    std::vector<FittedTrial> trials;
    const Start start = zero_start(model_.spec);
    try {
      for (const Excitation& excitation : task_.excitations)
        trials.push_back({excitation, predict(model_, values, excitation, start)});
    } catch (const std::runtime_error&) {
      return 1e6;
    }
    const PlantFit fit = fit_plant(task_.made.base, trials, base_values_, std::vector<Start>(trials.size(), start),
                                   by_deviation(floor_), {.most_iterations = 6, .enough = 1e-3});
    return fit.valid ? fit.rms() : 1e6;
  }

  const SizedLaw& task_;
  std::vector<double> floor_;
  PlantModel model_;
  Eigen::VectorXd base_values_;
};

std::vector<double> rms_of(const PlantModel& model, const PlantFit& fit, const std::vector<FittedTrial>& trials) {
  std::vector<Readings> left;
  for (std::size_t t = 0; t < trials.size(); ++t)
    left.push_back(difference(trials[t].readings, predict(model, fit.values, trials[t].excitation, fit.starts[t])));
  return rms_by_sensor(left);
}

}  // namespace

std::vector<double> parameters_of_strength(const SizedLaw& task, double wanted) { return SizeSearch(task).run(wanted); }

void measure_strength(MadeCase& made) {
  std::vector<FittedTrial> trials;
  for (const MadeTrial& trial : made.trials)
    if (!trial.held_out) trials.push_back(trial.fitted());
  const std::vector<Start> starts(trials.size(), zero_start(made.base.spec));
  const PlantSpec& spec = made.base.spec;
  std::vector<double> deviations(spec.sensors.size(), 1.0);
  for (std::size_t s = 0; s < deviations.size(); ++s)
    deviations[s] = std::hypot(made.noise.sensor_white[s], made.noise.sensor_slow[s], made.noise.quantum[s] / 3.5);
  const Whiten whiten = by_deviation(deviations);
  const PlantFit truth = fit_plant(made.truth, trials, made.truth_values, starts, whiten);
  const PlantFit base = fit_plant(made.base, trials, made.base_values, starts, whiten);
  if (!truth.valid || !base.valid) throw std::runtime_error(made.plan.name() + " cannot be refitted");
  made.truth_rms = rms_of(made.truth, truth, trials);
  made.base_rms = rms_of(made.base, base, trials);
  double ratios = 0.0;
  for (std::size_t s = 0; s < made.base_rms.size(); ++s) ratios += std::pow(made.base_rms[s] / made.truth_rms[s], 2);
  made.strength = std::sqrt(ratios / static_cast<double>(made.base_rms.size()));
  made.absorbed = !made.plan.hidden.empty() && made.strength < kAbsorbed;
}

}  // namespace hidden_effects
