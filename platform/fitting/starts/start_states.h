#pragma once

#include <lacuna/robot_spec.h>

#include "evaluation/prediction/trial_predictor.h"
#include "fitting/starts/free_reading.h"
#include "fitting/starts/sensor_noise.h"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

inline constexpr double kHead = 0.05;  ///< s of measurement from which an initial state is estimated

/// An initial state with the uncertainty of each component. Components are positions first, then velocities: coordinate
/// c's velocity is component n + c.
struct StartEstimate {
  bool valid = false;
  StartState start;
  Eigen::VectorXd deviation;  ///< standard deviations, 2 n; 0: exact; infinite: not measured
  /// Possible errors of the start, one direction per column: independent, each one standard deviation long, together
  /// the covariance of the measured components.
  Eigen::MatrixXd axes;
  /// RMS of the residuals of the first samples over their noise, at least 1; part of the deviations.
  double misfit = 1.0;

  /// Whether component `index` was estimated from data, rather than given or not measured.
  bool tells(int index) const { return deviation(index) > 0.0 && std::isfinite(deviation(index)); }
  bool known_from_data() const {
    for (int index = 0; index < deviation.size(); ++index)
      if (tells(index)) return true;
    return false;
  }
};

/// The start, moved by `times` standard deviations along one of its axes.
StartState moved_along(const StartEstimate& estimate, Eigen::Index axis, double times = 1.0);

/// Whether a body has no joint, not even a free one.
bool has_floating_body(const RobotSpec& robot);

double component(const StartState& start, int index);
void set_component(StartState& start, int index, double value);

/// Which measured channels determine the joint coordinates of a model, and their values at a sample. Const and shared
/// by threads.
class StartStates {
 public:
  /// `noise`: deviations of the measured channels (see sensor_noise).
  StartStates(const RobotSpec& robot, const TrialPredictor& predictor, const std::vector<ChannelNoise>& noise);

  /// A channel that measures a coordinate: reading = scale · value + offset.
  struct Reading {
    Eigen::Index channel = -1;
    double scale = 1.0;
    double offset = 0.0;
    std::vector<std::pair<int, double>> others = {};  ///< of a link's angle: further coordinates in it, and their signs
  };

  int coordinates() const { return coordinates_; }
  /// The channels that determine a coordinate of a trial, if any.
  const std::optional<Reading>& position_reading(std::size_t trial, int coordinate) const {
    return readings_[trial].positions[static_cast<std::size_t>(coordinate)];
  }
  const std::optional<Reading>& velocity_reading(std::size_t trial, int coordinate) const {
    return readings_[trial].velocities[static_cast<std::size_t>(coordinate)];
  }
  /// Coordinates in an order in which those contained in a link's angle come before the link's own.
  const std::vector<int>& outward() const { return outward_; }
  /// Coordinates coupled to others start where the engine puts them: they are known, not separate unknowns.
  void follow(StartEstimate& estimate) const;
  /// Why not every sample of this trial can be a start: a coordinate whose position is not measured, a floating body,
  /// or a memory that no reading shows (delayed readings, states of effects, a PID's integral, a compliant
  /// transmission's rotor), which would be empty in a simulation from the middle. Nothing where every sample can.
  std::string obstacle(std::size_t trial) const;
  bool reconstructible(std::size_t trial) const { return obstacle(trial).empty(); }
  /// Length of a trial's prediction before it restarts, s (restarts.h).
  double restart(std::size_t trial) const { return restarts_[trial]; }
  /// Names of the coordinates whose position the trial does not measure.
  std::vector<std::string> unmeasured(std::size_t trial) const;
  /// The standard deviation of a measured channel of a trial.
  double deviation(std::size_t trial, Eigen::Index channel) const;

  /// Positions and velocities at a sample of the stretch from low-order polynomials through the samples near it, none
  /// outside the stretch; deviations are those of the polynomials. A coordinate that is not measured is zero, or, at a
  /// trial's first sample, as the trial states it, with an infinite deviation.
  StartEstimate from_samples(const Stretch& stretch, Eigen::Index sample) const;

  /// Whether the trial states this coordinate exactly, which counts for its first sample.
  static bool given(const Trial& trial, int coordinate);

 private:
  /// A coordinate coupled to another one.
  struct Follower {
    int coordinate = 0, leader = 0;
    double ratio = 1.0, offset = 0.0;
  };
  struct TrialReadings {
    std::vector<std::optional<Reading>> positions, velocities;  ///< per coordinate
    std::vector<std::pair<int, FreeReading>> free;              ///< first coordinate of each free joint
    std::vector<double> deviations;                             ///< per measured channel
  };

  TrialReadings readings_of(const RobotSpec& robot, const Trial& trial, const std::vector<ChannelNoise>& noise) const;
  void order_outward(const RobotSpec& robot);
  bool follows(int coordinate) const;
  bool told_by_body(std::size_t trial, int coordinate) const;
  /// Writes the estimate of coordinate `c` from the channels.
  void read_coordinate(const Stretch& stretch, Eigen::Index sample, int c, StartEstimate& estimate) const;
  /// Of all coordinates of free joints that are not given.
  void read_free_joints(const Stretch& stretch, Eigen::Index sample, StartEstimate& estimate) const;

  const std::vector<Trial>& trials_;
  int coordinates_ = 0;
  /// Coordinates in an order in which those contained in a link's angle come before the link's own.
  std::vector<int> outward_;
  std::vector<Follower> followers_;
  std::string hidden_;  ///< the part of the model's state that no measurement shows; empty: none
  std::vector<std::string> names_;
  std::vector<TrialReadings> readings_;
  std::vector<double> restarts_;  ///< s
};

}  // namespace lacuna
