#include "prediction/start_by_readings.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr int kRounds = 2;
constexpr double kNudge = 1e-4;  ///< rad or m, by which the slope of a reading is found
constexpr double kSame = 1e-9;   ///< of a reading, rad or m: the model changes nothing of it
constexpr double kFlattest = 0.2, kSteepest = 5.0;

/// A model's first reading of one coordinate.
class FirstReading {
 public:
  FirstReading(const ReadStart& read, const StartStates::Reading& reading, Prediction& prediction)
      : read_(read), reading_(reading), prediction_(prediction) {}

  /// NaN where it cannot be simulated.
  double at(const StartState& start) const {
    const Stretch first{read_.stretch.trial, read_.stretch.first, read_.stretch.first + 2};
    read_.predictor.predict(first, read_.values, start, read_.worker, prediction_, read_.warm_up);
    return prediction_.valid ? prediction_.samples(0, reading_.channel) : std::nan("");
  }

  /// What a plain sensor reads.
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

void follow_reading(const ReadStart& read, const StartStates::Reading& reading, int coordinate,
                    const StartState& smoothed, StartState& start, Prediction& prediction) {
  const FirstReading first(read, reading, prediction);
  const double wanted = first.plain(smoothed, coordinate);
  for (int round = 0; round < kRounds; ++round) {
    const double here = first.at(start);
    StartState beside = start;
    set_component(beside, coordinate, component(start, coordinate) + kNudge);
    const double slope = (first.at(beside) - here) / kNudge / reading.scale;
    if (!std::isfinite(slope)) return;
    const bool follows = slope > kFlattest && slope < kSteepest;
    set_component(start, coordinate,
                  component(start, coordinate) + (wanted - here) / reading.scale / (follows ? slope : 1.0));
    if (follows) {
      const int velocity = read.states.coordinates() + coordinate;
      set_component(start, velocity, component(smoothed, velocity) / slope);
    }
  }
}

}  // namespace

StartState start_by_readings(const ReadStart& read, const StartState& start, Prediction& prediction) {
  const Stretch first{read.stretch.trial, read.stretch.first, read.stretch.first + 2};
  read.predictor.predict(first, read.values, start, read.worker, prediction, read.warm_up);
  if (!prediction.valid) return start;
  const Eigen::RowVectorXd readings = prediction.samples.row(0);
  StartState changed = start;
  for (const int coordinate : read.states.outward())
    if (const auto& reading = read.states.position_reading(read.stretch.trial, coordinate)) {
      const double plain = FirstReading(read, *reading, prediction).plain(start, coordinate);
      if (std::abs(readings(reading->channel) - plain) > kSame * std::max(1.0, std::abs(plain)))
        follow_reading(read, *reading, coordinate, start, changed, prediction);
    }
  return changed;
}

}  // namespace lacuna
