#include "baselines/recorded_motion.h"

#include "baselines/zero_phase.h"
#include "cases/scales_of.h"

namespace hidden_effects {
namespace {

constexpr double kLeastCutoff = 4.0, kMostCutoff = 30.0;  ///< Hz
constexpr double kWider = 3.0;

std::vector<double> central_differences(const std::vector<double>& x, double interval) {
  std::vector<double> slopes(x.size(), 0.0);
  for (std::size_t k = 1; k + 1 < x.size(); ++k) slopes[k] = (x[k + 1] - x[k - 1]) / (2.0 * interval);
  return slopes;
}

std::vector<double> second_differences(const std::vector<double>& x, double interval) {
  std::vector<double> bends(x.size(), 0.0);
  for (std::size_t k = 1; k + 1 < x.size(); ++k) bends[k] = (x[k + 1] - 2.0 * x[k] + x[k - 1]) / (interval * interval);
  return bends;
}

RecordedMotion moved(const PlantSpec& spec, const FittedTrial& trial, double cutoff) {
  const std::vector<std::vector<double>> still(spec.joints.size(),
                                               std::vector<double>(trial.excitation.samples(), 0.0));
  RecordedMotion motion{still, still, still};
  const double interval = trial.excitation.interval;
  for (std::size_t s = 0; s < spec.sensors.size(); ++s) {
    if (spec.sensors[s].velocity) continue;
    const auto joint = static_cast<std::size_t>(spec.sensors[s].joint);
    motion.position[joint] = zero_phase(trial.readings[s], interval, cutoff);
    motion.velocity[joint] = central_differences(motion.position[joint], interval);
    motion.acceleration[joint] = second_differences(motion.position[joint], interval);
  }
  return motion;
}

}  // namespace

RecordedMotions recorded_motions(const Observed& seen) {
  std::vector<std::vector<double>> positions;
  for (const FittedTrial& trial : seen.trials)
    for (std::size_t s = 0; s < trial.readings.size(); ++s)
      if (!seen.base.spec.sensors[s].velocity) positions.push_back(trial.readings[s]);
  RecordedMotions motions;
  motions.cutoff = bandwidth(positions, seen.trials.front().excitation.interval, kLeastCutoff, kMostCutoff);
  for (const FittedTrial& trial : seen.trials)
    motions.trials.push_back(moved(seen.base.spec, trial, kWider * motions.cutoff));
  return motions;
}

Scales recorded_scales(const Observed& seen, const RecordedMotions& motions, Place place, int element) {
  std::vector<Excitation> excitations;
  std::vector<Motion> as_motions;
  for (std::size_t t = 0; t < seen.trials.size(); ++t) {
    excitations.push_back(seen.trials[t].excitation);
    as_motions.push_back({excitations.back().interval, 1, motions.trials[t].position, motions.trials[t].velocity});
  }
  return scales_of(seen.base.spec, place, element, excitations, as_motions);
}

}  // namespace hidden_effects
