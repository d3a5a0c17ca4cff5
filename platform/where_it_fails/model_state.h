#pragma once

#include "fitting/comparison.h"

#include <optional>
#include <vector>

namespace lacuna {

/// The state of the model during a free run; samples of the trial × coordinates or bodies, SI. Coordinates of free
/// joints stay at zero.
struct ModelState {
  Eigen::MatrixXd positions, velocities;
  Eigen::MatrixXd loads;     ///< generalised force of actuators and joint laws in the last step
  Eigen::MatrixXd contacts;  ///< ±1 like a touch sensor, for each body with shapes; no columns without a ground
};

/// Reads the state of a model with additional sensors, which change nothing else.
class ModelStates {
 public:
  explicit ModelStates(const ModelDefinition& definition, const Stop& stop = {});

  /// The bodies of `ModelState::contacts`.
  const std::vector<std::string>& bodies() const { return bodies_; }
  const std::vector<Coordinate>& coordinates() const { return model_->coordinates(); }
  /// The states in the free run of `trial` from its start state; nothing where it cannot be simulated. Makes its own
  /// workspace, so that threads may call it at the same time.
  std::optional<ModelState> of(const Trial& trial, const StartState& start, const std::vector<double>& values) const;

 private:
  /// Values of a block of joint sensors, in the order of coordinates.
  Eigen::MatrixXd of_all_coordinates(const TimeSeries::Samples& samples, Eigen::Index block) const;

  std::vector<Eigen::Index> read_;  ///< coordinates with joint sensors
  std::vector<Channel> extra_;      ///< positions, velocities, loads, contacts
  std::vector<std::string> bodies_;
  std::unique_ptr<CompiledModel> model_;
  Stop stop_;
};

}  // namespace lacuna
