#pragma once

#include <lacuna/test.h>

#include <cstddef>
#include <vector>

namespace lacuna {

/// A proportional-derivative law on one reading: command = proportional · (reference − reading) − derivative · (change
/// of the reading since the sample before / time since then). It knows no limits; those are the actuator's.
struct ControlLaw {
  std::size_t actuator = 0;         ///< among all of the robot's
  std::size_t sensor = 0;           ///< channel, among all of the robot's
  Eigen::Index command_column = 0;  ///< in the trial's commands
  Eigen::Index reading_column = 0;  ///< in what the trial measured
  double proportional = 0.0;        ///< command's unit per sensor's unit
  double derivative = 0.0;          ///< command's unit × s per sensor's unit
};

/// What a trial recorded, all with the same times.
struct RecordedSignals {
  TimeSeries references;  ///< one channel a law
  CommandSeries commands;
  std::vector<std::size_t> actuator_of;  ///< by command channel: among all of the robot's
  TimeSeries measured;
};

/// The controller of a recorded trial: acts at the trial's own samples, whatever the integration step, and replays what
/// was recorded of actuators without a law. Where a simulation begins in the middle of the trial, the reading before is
/// what was measured then.
class RecordedController : public Controller {
 public:
  RecordedController(std::vector<ControlLaw> laws, RecordedSignals signals);

  int state_size() const override { return 1 + static_cast<int>(laws_.size()); }
  void act(double time, std::span<const double> sensors, std::span<double> state,
           std::span<double> commands) const override;

  const std::vector<ControlLaw>& laws() const { return laws_; }
  const CommandSeries& commands() const { return signals_.commands; }
  /// What the law makes of the recorded readings, a value a sample; NaN where a reading is missing.
  Eigen::VectorXd of_recorded_readings(std::size_t law) const;

 private:
  Eigen::Index sample_at(double time) const;
  double command(std::size_t law, Eigen::Index sample, double reading, double before) const;
  double measured_before(std::size_t law, Eigen::Index sample, double reading) const;

  const std::vector<ControlLaw> laws_;
  const RecordedSignals signals_;
};

}  // namespace lacuna
