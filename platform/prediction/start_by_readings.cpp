#include "prediction/start_by_readings.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr int kRounds = 2;
constexpr double kNudge = 1e-4;  ///< rad or m, step for the slope of a reading
constexpr double kSame = 1e-9;   ///< of a reading, rad or m: within this the model's sensor is ideal
constexpr double kFlattest = 0.2, kSteepest = 5.0;

/// The first sample alone, which needs no step of the stretch.
Stretch first_sample(const Stretch& stretch) { return {stretch.trial, stretch.first, stretch.first + 1}; }

/// A model's first reading of one coordinate.
class FirstReading {
 public:
  FirstReading(const ReadStart& read, const StartStates::Reading& reading, Prediction& prediction)
      : read_(read), reading_(reading), prediction_(prediction) {}

  /// NaN where it cannot be simulated.
  double at(const StartState& start) const {
    read_.predictor.predict(first_sample(read_.stretch), read_.values, start, read_.worker, prediction_, read_.warm_up);
    return prediction_.valid ? prediction_.samples(0, reading_.channel) : std::nan("");
  }

  /// The value that an ideal sensor reads.
  double plain(const StartState& start, int coordinate) const {
    double value = component(start, coordinate);
    for (const auto& [other, sign] : reading_.others) value += sign * component(start, other);
    return reading_.scale * value + reading_.offset;
  }

 private:
  const ReadStart& read_;
  const StartStates::Reading& reading_;
  Prediction& prediction_;
};

/// Whether the reading increases with the measured coordinate.
bool follow_reading(const ReadStart& read, const StartStates::Reading& reading, int coordinate,
                    const StartState& smoothed, StartState& start, Prediction& prediction) {
  const FirstReading first(read, reading, prediction);
  const double wanted = first.plain(smoothed, coordinate);
  for (int round = 0; round < kRounds; ++round) {
    const double here = first.at(start);
    StartState beside = start;
    set_component(beside, coordinate, component(start, coordinate) + kNudge);
    const double slope = (first.at(beside) - here) / kNudge / reading.scale;
    if (slope < 0.0) return false;
    if (!(slope > kFlattest && slope < kSteepest)) return true;
    set_component(start, coordinate, component(start, coordinate) + (wanted - here) / reading.scale / slope);
    const int velocity = read.starts.states().coordinates() + coordinate;
    set_component(start, velocity, component(smoothed, velocity) / slope);
  }
  return true;
}

/// The last sample before the event that is read first, so that it is predicted from no later reading.
Eigen::Index before_it_happened(const ReadStart& read, const std::vector<double>& lateness, Eigen::Index earliest) {
  const Eigen::VectorXd& times = read.predictor.trials()[read.stretch.trial].measured.times;
  const double begin = times(read.stretch.first) - *std::max_element(lateness.begin(), lateness.end());
  Eigen::Index at = read.stretch.first - 1;
  while (at > earliest && times(at) > begin) --at;
  return at;
}

/// A warm-up that begins at a sample and reaches about the state at which the stretch starts.
void lead_to(const StartState& start, const ReadStart& read, const std::vector<double>& lateness, WarmUp& warm_up) {
  const std::size_t trial = read.stretch.trial;
  const Eigen::VectorXd& times = read.predictor.trials()[trial].measured.times;
  const auto late_start_at = [&](Eigen::Index sample) {
    StartState late = read.starts.at(trial, sample).start;
    read.starts.move_later(trial, sample, lateness, late);
    return late;
  };
  const StartState there = late_start_at(read.stretch.first);
  const double seconds = times(read.stretch.first) - times(warm_up.first);
  warm_up.start = late_start_at(warm_up.first);
  const int n = read.starts.states().coordinates();
  for (int c = 0; c < n; ++c) {
    const double further = component(start, c) - component(there, c);
    const double faster = component(start, n + c) - component(there, n + c);
    set_component(warm_up.start, c, component(warm_up.start, c) + further - seconds * faster);
    set_component(warm_up.start, n + c, component(warm_up.start, n + c) + faster);
  }
}

/// Coordinates whose readings are late by half an interval or more continue from the warm-up.
void leave_to_warm_up(const ReadStart& read, const std::vector<double>& lateness, StartState& start) {
  const StartStates& states = read.starts.states();
  const Eigen::VectorXd& times = read.predictor.trials()[read.stretch.trial].measured.times;
  const double interval = times(read.stretch.first) - times(read.stretch.first - 1);
  for (const int c : states.outward()) {
    const auto& reading = states.position_reading(read.stretch.trial, c);
    if (!reading || !(lateness[static_cast<std::size_t>(reading->channel)] > 0.5 * interval)) continue;
    set_component(start, c, std::nan(""));
    set_component(start, states.coordinates() + c, std::nan(""));
  }
}

}  // namespace

ChangedStart start_by_readings(const ReadStart& read, const StartState& start, Prediction& prediction) {
  ChangedStart changed{start, read.warm_up ? std::optional(*read.warm_up) : std::nullopt, false};
  read.predictor.predict(first_sample(read.stretch), read.values, start, read.worker, prediction, read.warm_up);
  if (!prediction.valid) return changed;
  const Eigen::RowVectorXd readings = prediction.samples.row(0);
  const std::vector<double> lateness = prediction.lateness;
  const StartStates& states = read.starts.states();
  for (const int coordinate : states.outward())
    if (const auto& reading = states.position_reading(read.stretch.trial, coordinate)) {
      const double plain = FirstReading(read, *reading, prediction).plain(start, coordinate);
      if (lateness[static_cast<std::size_t>(reading->channel)] == 0.0 &&
          std::abs(readings(reading->channel) - plain) > kSame * std::max(1.0, std::abs(plain)))
        changed.reads_backwards |= !follow_reading(read, *reading, coordinate, start, changed.start, prediction);
    }
  if (std::all_of(lateness.begin(), lateness.end(), [](double late) { return late == 0.0; })) return changed;
  read.starts.move_later(read.stretch.trial, read.stretch.first, lateness, changed.start);
  if (!changed.warm_up) return changed;
  changed.warm_up->first = before_it_happened(read, lateness, changed.warm_up->first);
  lead_to(changed.start, read, lateness, *changed.warm_up);
  leave_to_warm_up(read, lateness, changed.start);
  return changed;
}

}  // namespace lacuna
