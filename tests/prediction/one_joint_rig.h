#pragma once

#include "fitting/analytic_models.h"
#include "prediction/linear_prediction.h"

#include <memory>
#include <vector>

namespace lacuna {

inline constexpr double kRigNoise = 1e-3;    ///< rad
inline constexpr double kRigRate = 100.0;    ///< Hz
inline constexpr double kStartAngle = 0.3;   ///< rad
inline constexpr double kStartSpeed = -0.2;  ///< rad/s

/// A joint that is integrated here, recordings of it from one initial state, and the means to predict them.
class OneJointRig {
 public:
  using Model = analytic::OneJointModel;

  /// `truth`: the values of the recordings, which the model `robot_acceleration` made; `durations`: of these, s.
  OneJointRig(const Model::Acceleration& acceleration, const std::vector<FreeValue>& free,
              const std::vector<double>& truth, const std::vector<double>& durations = {4.0}, int threads = 1,
              const Model::Acceleration& robot_acceleration = {})
      : definition(analytic::define(free, analytic::one_joint_robot())),
        model(acceleration),
        trials(recordings(robot_acceleration ? robot_acceleration : acceleration, truth, durations)),
        noise(sensor_noise(definition.structure.robot, trials)),
        predictor(model, trials, {threads}),
        states(definition.structure.robot, predictor, noise),
        starts(states, predictor.trials()),
        space(definition.free) {}
  OneJointRig(const OneJointRig&) = delete;
  OneJointRig& operator=(const OneJointRig&) = delete;

  LadderSource source(bool held_out = false) const {
    return {definition.structure.robot, predictor, states, starts, noise, held_out};
  }
  PredictionLadder ladder(const std::vector<double>& lengths, std::size_t most = 100) const {
    return ladder_of(source(), lengths, most);
  }
  LadderPredictions predictions(const PredictionLadder& of) const { return {of, predictor, space, starts}; }
  Eigen::VectorXd at(const std::vector<double>& values) const { return space.to_coordinates(values); }

  ModelDefinition definition;
  Model model;
  std::vector<Trial> trials;
  std::vector<ChannelNoise> noise;
  TrialPredictor predictor;
  StartStates states;
  SmoothedStarts starts;
  ParameterSpace space;

 private:
  static std::vector<Trial> recordings(const Model::Acceleration& acceleration, const std::vector<double>& truth,
                                       const std::vector<double>& durations) {
    const Model robot(acceleration);
    std::vector<Trial> all;
    for (const double duration : durations)
      all.push_back(analytic::record(
          robot, truth, analytic::regular_times(static_cast<Eigen::Index>(kRigRate * duration) + 1, kRigRate),
          analytic::two_sines(duration, 1.5), {{kStartAngle}, {kStartSpeed}}, kRigNoise, all.size() + 1));
    return all;
  }
};

/// q'' = a, whose motion is a parabola; value: a, rad/s².
inline double constant_acceleration(std::span<const double> values, double, double, double) { return values[0]; }
inline StartState parabola_at(double a, double time) {
  return {{kStartAngle + kStartSpeed * time + 0.5 * a * time * time}, {kStartSpeed + a * time}};
}

/// q'' = u − b q' − 4 q; value: b, 1/s.
inline double damped_spring(std::span<const double> values, double q, double v, double u) {
  return u - values[0] * v - 4.0 * q;
}

}  // namespace lacuna
