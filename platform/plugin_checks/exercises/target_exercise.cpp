#include "plugin_checks/exercises/exercises.h"

#include <lacuna/error.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr Eigen::Index kTargetSamples = 100;
constexpr double kTargetPeriod = 0.01;  // s

/// A slow sine on one motor.
Test motor_test(double amplitude) {
  CommandSeries commands;
  commands.series.channels = {{"motor", "N*m"}};
  commands.series.times.resize(kTargetSamples);
  commands.series.samples.resize(kTargetSamples, 1);
  for (Eigen::Index i = 0; i < kTargetSamples; ++i) {
    commands.series.times(i) = kTargetPeriod * static_cast<double>(i);
    commands.series.samples(i, 0) = amplitude * std::sin(6.0 * commands.series.times(i));
  }
  Test test;
  test.duration = kTargetPeriod * kTargetSamples;
  test.start = {{0.1}, {0.0}};
  test.drive = std::move(commands);
  return test;
}

/// The host's services: the commands, and an angle that follows them.
Trial served_trial(const Test& test) {
  Trial trial;
  trial.name = "served";
  trial.commands = std::get<CommandSeries>(test.drive);
  trial.measured = trial.commands.series;
  trial.measured.channels = {{"angle", "rad"}};
  trial.measured.samples *= 0.1;
  return trial;
}

class ServedTrials : public TrialReader {
 public:
  std::vector<Trial> read() const override { return {served_trial(motor_test(0.3))}; }
};

class ServedSimulator : public Simulator {
 public:
  Trial simulate(const Test& test) const override { return served_trial(test); }
};

class ServedProgram : public ExternalProgram {
 public:
  Trial carry_out(const Test& test) override { return served_trial(test); }
};

/// The fault of a trial; empty: none.
std::string trial_fault(const Trial& trial) {
  const TimeSeries& measured = trial.measured;
  if (measured.times.size() == 0) return "a trial has no reading";
  if (measured.samples.rows() != measured.times.size() ||
      measured.samples.cols() != static_cast<Eigen::Index>(measured.channels.size()))
    return "readings do not have one row per time and one column per channel";
  for (Eigen::Index i = 1; i < measured.times.size(); ++i)
    if (!(measured.times(i) > measured.times(i - 1))) return "times of readings do not increase";
  for (const Channel& channel : measured.channels)
    if (channel.name.empty() || channel.unit.empty()) return "a channel has no name or no unit";
  if (trial.commands.series.channels.empty() || trial.commands.series.samples.rows() == 0)
    return "a trial does not contain the applied commands; fill `commands`";
  return {};
}

class TargetExercise : public Exercise {
 public:
  TargetExercise(TargetMaker make, bool carries_out) : make_(std::move(make)), carries_out_(carries_out) {}

  ParameterDeclarations declared() const override { return make_()->parameters(); }
  bool promises_same_numbers() const override { return false; }

  void go(const Setting&, Transcript& transcript) const override {
    const std::unique_ptr<TargetSystem> target = make_();
    transcript.add("takes_tests", target->takes_tests() ? 1.0 : 0.0);
    for (const Trial& trial : trials_of(*target)) {
      transcript.add("measuring",
                     std::span(trial.measured.times.data(), static_cast<std::size_t>(trial.measured.times.size())));
      transcript.add("measuring",
                     std::span(trial.measured.samples.data(), static_cast<std::size_t>(trial.measured.samples.size())),
                     Transcript::May::be_anything);
    }
  }

  std::vector<std::string> broken_promises() const override {
    const std::unique_ptr<TargetSystem> target = make_();
    for (const Trial& trial : trials_of(*target))
      if (const std::string fault = trial_fault(trial); !fault.empty()) return {fault};
    return {};
  }

  std::string reservation() const override {
    return carries_out_ || !make_()->takes_tests() ? ""
                                                   : "no test was carried out, because it would move a rig; "
                                                     "--carry-out carries one out: 1 s of ±0.2 and ±0.4 N*m";
  }

 private:
  std::vector<Trial> trials_of(TargetSystem& target) const {
    const ServedTrials reader;
    const ServedSimulator simulator;
    ServedProgram program;
    const TargetServices services = {&reader, &simulator, &program};
    std::vector<Trial> trials = target.recorded(services);
    if (carries_out_ && target.takes_tests())
      for (const double amplitude : {0.2, 0.4}) trials.push_back(target.carry_out(motor_test(amplitude), services));
    return trials;
  }

  TargetMaker make_;
  bool carries_out_;
};

}  // namespace

std::unique_ptr<Exercise> exercise_of_target(TargetMaker make, const ExerciseInputs& inputs) {
  return std::make_unique<TargetExercise>(std::move(make), inputs.carries_out);
}

}  // namespace lacuna
