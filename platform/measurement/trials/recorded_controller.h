#pragma once

#include <lacuna/robot_spec.h>
#include <lacuna/test.h>

#include <cstddef>
#include <vector>

namespace lacuna {

/// A control law on one reading: command = proportional · e + ∫ integral · e dt − derivative · dy/dt, within ±limit,
/// where e is the reference minus the reading and y the reading after a first-order low-pass. It is evaluated at the
/// trial's samples: dy/dt is a backward difference, and the integral stops while the command is at its limit and would
/// go further into it.
struct ControlLaw {
  std::size_t actuator = 0;         ///< among all of the robot's
  std::size_t sensor = 0;           ///< channel, among all of the robot's
  Eigen::Index command_column = 0;  ///< in the trial's commands
  Eigen::Index reading_column = 0;  ///< in what the trial measured
  double proportional = 0.0;        ///< command's unit per sensor's unit
  double derivative = 0.0;          ///< command's unit × s per sensor's unit
  double integral = 0.0;            ///< command's unit per sensor's unit and s
  double limit = kInfinity;         ///< command's unit
  double filter = 0.0;              ///< s, time constant of the low-pass; 0: none
};

/// Recorded data of a trial, all with the same times.
struct RecordedSignals {
  TimeSeries references;  ///< one channel per law
  CommandSeries commands;
  std::vector<std::size_t> actuator_of;  ///< by command channel: among all of the robot's
  TimeSeries measured;
};

/// The controller of a recorded trial: acts at the trial's own samples, whatever the integration step, and replays the
/// recorded commands of actuators without a law. Where a simulation begins in the middle of the trial, the previous
/// reading is the measured one, and an integral gets the value that gives the recorded command.
class RecordedController : public Controller {
 public:
  RecordedController(std::vector<ControlLaw> laws, RecordedSignals signals);

  std::string identity() const override;
  int state_size() const override { return 1 + kMemory * static_cast<int>(laws_.size()); }
  void act(double time, std::span<const double> sensors, std::span<double> state,
           std::span<double> commands) const override;

  const std::vector<ControlLaw>& laws() const { return laws_; }
  const CommandSeries& commands() const { return signals_.commands; }
  /// The law's command from the recorded readings, one value per sample; NaN where a reading is missing.
  Eigen::VectorXd of_recorded_readings(std::size_t law) const;

 private:
  static constexpr int kMemory = 2;
  /// A law's memory from sample to sample.
  struct Memory {
    double smooth = 0.0;    ///< the reading after the low-pass
    double integral = 0.0;  ///< command's unit
  };

  Eigen::Index sample_at(double time) const;
  double interval_before(Eigen::Index sample) const;
  /// For a simulation that begins at a sample with a reading.
  Memory memory_at(std::size_t law, Eigen::Index sample, double reading) const;
  /// Advances the memory to the sample.
  double command(std::size_t law, Eigen::Index sample, double reading, Memory& memory) const;
  /// The same without the limit.
  double asked(std::size_t law, Eigen::Index sample, double reading, const Memory& memory) const;
  double smoothed(std::size_t law, Eigen::Index sample, double reading, const Memory& memory) const;
  double error(std::size_t law, Eigen::Index sample, double reading) const;

  const std::vector<ControlLaw> laws_;
  const RecordedSignals signals_;
};

}  // namespace lacuna
