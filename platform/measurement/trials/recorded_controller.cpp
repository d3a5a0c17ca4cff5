#include "measurement/trials/recorded_controller.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace lacuna {
namespace {

constexpr double kClockTolerance = 1e-9;  // s

}  // namespace

RecordedController::RecordedController(std::vector<ControlLaw> laws, RecordedSignals signals)
    : laws_(std::move(laws)), signals_(std::move(signals)) {}

std::string RecordedController::identity() const {
  std::string text;
  for (const ControlLaw& law : laws_)
    text += fmt::format("{} {} {} {} {} {} {};", law.actuator, law.sensor, law.proportional, law.derivative,
                        law.integral, law.limit, law.filter);
  for (const double reference : signals_.references.samples.reshaped()) text += fmt::format(" {}", reference);
  return text;
}

Eigen::Index RecordedController::sample_at(double time) const {
  const Eigen::VectorXd& times = signals_.measured.times;
  const auto next = std::upper_bound(times.begin(), times.end(), time + kClockTolerance);
  return std::max<Eigen::Index>(0, next - times.begin() - 1);
}

double RecordedController::interval_before(Eigen::Index sample) const {
  const Eigen::VectorXd& times = signals_.measured.times;
  return sample > 0 ? times(sample) - times(sample - 1) : 0.0;
}

double RecordedController::error(std::size_t law, Eigen::Index sample, double reading) const {
  return signals_.references.samples(sample, static_cast<Eigen::Index>(law)) - reading;
}

RecordedController::Memory RecordedController::memory_at(std::size_t index, Eigen::Index sample, double reading) const {
  const ControlLaw& law = laws_[index];
  Memory memory{reading, 0.0};
  if (sample > 0) {
    const double before = signals_.measured.samples(sample - 1, law.reading_column);
    if (std::isfinite(before)) memory.smooth = before;
  }
  if (law.integral == 0.0) return memory;
  const double sent = signals_.commands.series.samples(sample, law.command_column);
  const double rest = sent - asked(index, sample, reading, memory);
  if (std::isfinite(rest)) memory.integral = rest;
  return memory;
}

double RecordedController::smoothed(std::size_t index, Eigen::Index sample, double reading,
                                    const Memory& memory) const {
  const double filter = laws_[index].filter;
  const double share = filter > 0.0 ? -std::expm1(-interval_before(sample) / filter) : 1.0;
  return memory.smooth + share * (reading - memory.smooth);
}

double RecordedController::asked(std::size_t index, Eigen::Index sample, double reading, const Memory& memory) const {
  const ControlLaw& law = laws_[index];
  const double interval = interval_before(sample);
  const double rate = interval > 0.0 ? (smoothed(index, sample, reading, memory) - memory.smooth) / interval : 0.0;
  return law.proportional * error(index, sample, reading) + memory.integral - law.derivative * rate;
}

double RecordedController::command(std::size_t index, Eigen::Index sample, double reading, Memory& memory) const {
  const ControlLaw& law = laws_[index];
  const double error = this->error(index, sample, reading), wanted = asked(index, sample, reading, memory);
  if (std::abs(wanted) < law.limit || wanted * error * law.integral < 0.0)
    memory.integral += law.integral * error * interval_before(sample);
  memory.smooth = smoothed(index, sample, reading, memory);
  return std::clamp(wanted, -law.limit, law.limit);
}

void RecordedController::act(double time, std::span<const double> sensors, std::span<double> state,
                             std::span<double> commands) const {
  const Eigen::Index sample = sample_at(time);
  const double last = state[0] - 1.0;  // the sample at which it last acted; a state of zeros: none
  if (last == static_cast<double>(sample)) return;
  for (std::size_t c = 0; c < signals_.actuator_of.size(); ++c)
    commands[signals_.actuator_of[c]] = signals_.commands.series.samples(sample, static_cast<Eigen::Index>(c));
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    const double reading = sensors[laws_[law].sensor];
    double* const kept = &state[1 + kMemory * law];
    Memory memory = last < 0.0 ? memory_at(law, sample, reading) : Memory{kept[0], kept[1]};
    commands[laws_[law].actuator] = command(law, sample, reading, memory);
    kept[0] = memory.smooth;
    kept[1] = memory.integral;
  }
  state[0] = static_cast<double>(sample) + 1.0;
}

Eigen::VectorXd RecordedController::of_recorded_readings(std::size_t law) const {
  const auto readings = signals_.measured.samples.col(laws_[law].reading_column);
  Eigen::VectorXd commands(readings.size());
  commands.setConstant(std::nan(""));
  std::optional<Memory> memory;
  for (Eigen::Index i = 0; i < readings.size(); ++i) {
    if (!std::isfinite(readings(i))) continue;
    if (!memory) memory = memory_at(law, i, readings(i));
    commands(i) = command(law, i, readings(i), *memory);
  }
  return commands;
}

}  // namespace lacuna
