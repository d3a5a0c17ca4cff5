#include "measurement/recorded_controller.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lacuna {
namespace {

constexpr double kClockTolerance = 1e-9;  // s

}  // namespace

RecordedController::RecordedController(std::vector<ControlLaw> laws, RecordedSignals signals)
    : laws_(std::move(laws)), signals_(std::move(signals)) {}

Eigen::Index RecordedController::sample_at(double time) const {
  const Eigen::VectorXd& times = signals_.measured.times;
  const auto next = std::upper_bound(times.begin(), times.end(), time + kClockTolerance);
  return std::max<Eigen::Index>(0, next - times.begin() - 1);
}

double RecordedController::measured_before(std::size_t law, Eigen::Index sample, double reading) const {
  if (sample == 0) return reading;
  const double before = signals_.measured.samples(sample - 1, laws_[law].reading_column);
  return std::isfinite(before) ? before : reading;
}

double RecordedController::command(std::size_t law, Eigen::Index sample, double reading, double before) const {
  const Eigen::VectorXd& times = signals_.measured.times;
  const double rate = sample > 0 ? (reading - before) / (times(sample) - times(sample - 1)) : 0.0;
  const double reference = signals_.references.samples(sample, static_cast<Eigen::Index>(law));
  return laws_[law].proportional * (reference - reading) - laws_[law].derivative * rate;
}

void RecordedController::act(double time, std::span<const double> sensors, std::span<double> state,
                             std::span<double> commands) const {
  const Eigen::Index sample = sample_at(time);
  const double last = state[0] - 1.0;  // the sample that it acted at; a state of zeros: at none
  if (last == static_cast<double>(sample)) return;
  for (std::size_t c = 0; c < signals_.actuator_of.size(); ++c)
    commands[signals_.actuator_of[c]] = signals_.commands.series.samples(sample, static_cast<Eigen::Index>(c));
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    const double reading = sensors[laws_[law].sensor];
    const double before = last < 0.0 ? measured_before(law, sample, reading) : state[1 + law];
    commands[laws_[law].actuator] = command(law, sample, reading, before);
    state[1 + law] = reading;
  }
  state[0] = static_cast<double>(sample) + 1.0;
}

Eigen::VectorXd RecordedController::of_recorded_readings(std::size_t law) const {
  const auto readings = signals_.measured.samples.col(laws_[law].reading_column);
  Eigen::VectorXd commands(readings.size());
  for (Eigen::Index i = 0; i < readings.size(); ++i)
    commands(i) = command(law, i, readings(i), i > 0 ? readings(i - 1) : readings(i));
  return commands;
}

}  // namespace lacuna
