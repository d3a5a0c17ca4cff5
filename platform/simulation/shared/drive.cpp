#include "simulation/shared/drive.h"

#include "foundation/text/number_text.h"

#include <lacuna/error.h>

#include <cmath>

namespace lacuna::simulation {
namespace {

constexpr double kClockTolerance = 1e-9;  // control periods: tolerance of n·h/period against a whole number

}  // namespace

Drive::Drive(std::span<const Delay> longest, const EngineSettings& settings)
    : settings_(settings),
      h_(settings.step / settings.substeps),
      delays_(longest.size()),
      of_step_end_(longest.size()),
      held_(longest.size(), 0.0) {
  for (const Delay& delay : longest) lines_.emplace_back(delay);
}

void Drive::open_source(const Test& test, const RobotSpec& robot) {
  controller_ = nullptr;
  may_be_off_ = false;
  controller_state_.clear();
  if (const auto* series = std::get_if<CommandSeries>(&test.drive)) {
    may_be_off_ = series->may_be_off;
    recorded_.open(*series, robot);
    sent_.open(*series, robot);
  } else {
    controller_ = std::get<std::shared_ptr<const Controller>>(test.drive).get();
    if (!controller_) throw Error("the controller of the test is null");
    const int size = controller_->state_size();
    if (size < 0) throw Error("the controller asks for a negative state size");
    controller_state_.assign(static_cast<std::size_t>(size), 0.0);
  }
  std::fill(held_.begin(), held_.end(), 0.0);
  for (DelayLine& line : lines_) line.fill(0.0);
}

void Drive::open_delays(const RobotSpec& robot) {
  for (std::size_t i = 0; i < delays_.size(); ++i) {
    const ActuatorSpec& actuator = robot.actuators[i];
    if (!(actuator.delay >= 0.0 && actuator.delay < kInfinity))
      throw Error("actuator \"" + actuator.name + "\": its delay is " + number_text(actuator.delay) + " s");
    delays_[i] = make_delay(actuator.delay, settings_);
    of_step_end_[i] = actuator.kind == ActuatorKind::motion;
    if (!lines_[i].reaches(delays_[i]))
      throw Error("actuator \"" + actuator.name + "\": its delay of " + number_text(actuator.delay) +
                  " s is longer than its parameters' upper bounds allow");
  }
}

bool Drive::acts(std::uint64_t step) const {
  if (!controller_) return false;
  if (step == 0) return true;
  if (settings_.control_period == 0.0) return step % static_cast<std::uint64_t>(settings_.substeps) == 0;
  const double periods_per_step = h_ / settings_.control_period;
  const auto period = [&](std::uint64_t n) {
    return std::floor(static_cast<double>(n) * periods_per_step + kClockTolerance);
  };
  return period(step) > period(step - 1);
}

void Drive::act(double time, std::span<const double> sensors) {
  controller_->act(time, sensors, controller_state_, held_);
}

void Drive::begin_step(double time, bool first) {
  step_begin_ = time;
  if (!controller_) return;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (first) lines_[i].fill(held_[i]);  // before the first command, the first command
    lines_[i].push(held_[i]);
  }
}

double Drive::command(std::size_t actuator) {
  const Delay& delay = delays_[actuator];
  if (controller_) return delay.none() ? held_[actuator] : lines_[actuator].read(delay);
  return recorded(actuator, step_begin_);
}

double Drive::command_before(std::size_t actuator, double time) { return recorded(actuator, time - h_); }

double Drive::recorded(std::size_t actuator, double step_begin) {
  const Delay& delay = delays_[actuator];
  const double begin = step_begin - (static_cast<double>(delay.whole) + delay.fraction) * h_;
  if (of_step_end_[actuator]) return recorded_.at(actuator, begin + h_);
  return recorded_.mean(actuator, begin, begin + h_);
}

double Drive::sent(std::size_t actuator, double time) {
  return controller_ ? held_[actuator] : sent_.at(actuator, time);
}

void Drive::save_lines(StateWriter& writer) const {
  writer.put(held_);
  for (const DelayLine& line : lines_) line.save(writer);
}

void Drive::load_lines(StateReader& reader) {
  reader.get(held_);
  for (DelayLine& line : lines_) line.load(reader);
}

std::size_t Drive::lines_size() const {
  std::size_t size = held_.size();
  for (const DelayLine& line : lines_) size += line.size();
  return size;
}

}  // namespace lacuna::simulation
