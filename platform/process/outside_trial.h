#pragma once

#include <lacuna/test_encoding.h>
#include <lacuna/trial.h>

#include "process/hello.h"
#include "process/trial_messages.h"

#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// Between a model's channels and those of a target that fits it (`misfits` has nothing to say).
class ChannelOrder {
 public:
  ChannelOrder(const Hello& hello, const TestSpace& space);

  /// Commands of the model's actuators in the order of the hello's. Those that the series does not have are 0.
  CommandSeries of_target(const CommandSeries& commands) const;
  void commands_of_target(std::span<const double> commands, std::span<double> ordered) const;
  void readings_of_model(std::span<const double> readings, std::span<double> ordered) const;
  /// Throws `Error`, which continues "the program ...", for a reading of the model's sensors, in the order of the
  /// hello's, that the sensor cannot make.
  void check_readings(double time, std::span<const double> readings) const;
  /// The columns of the model's sensors, in its order.
  TimeSeries measured(const Eigen::VectorXd& times, const TimeSeries::Samples& values) const;
  TimeSeries applied(const Eigen::VectorXd& times, const TimeSeries::Samples& values) const;
  std::vector<double> sensor_noise() const;

 private:
  const Hello& hello_;
  const TestSpace& space_;
  std::vector<std::size_t> sensors_, actuators_;  ///< places of the model's channels in the hello
};

/// The command of each channel at a time.
void commands_at(const CommandSeries& commands, double time, std::span<double> values);

/// Without what comes after the end of a test of that duration (s); what is on its way to a later row gets one at the
/// end.
CommandSeries until(CommandSeries commands, double duration);

/// Throws `RefusedTest`, which continues "the program ...", where a series, in the order of the hello's actuators,
/// leaves what the target takes.
void check_limits(const CommandSeries& commands, const Hello& hello);

/// Throws `Error`, which continues "the program ...", where samples do not reach from the beginning of a test to its
/// end; drops those behind the end.
void check_extent(Samples& samples, const TestHeading& heading);
/// Throws the same where a sensor has measured nothing.
void check_measured(const TimeSeries& measured);

/// What is known of each coordinate at the start; empty where the target says nothing. Throws `Error`, which continues
/// "the program ...", where it names a joint that the model has not.
std::vector<InitialValue> initial_values(const JointStarts& start, const std::vector<std::string>& coordinates);

/// A start that is stated is that at 0 s, and models are simulated from the first row on: where that comes later, one
/// at 0 s goes before it, in which nothing is measured. Throws `Error`, which continues "the program ...", where it
/// comes before.
void begin_at_start(TimeSeries& measured);

}  // namespace lacuna
