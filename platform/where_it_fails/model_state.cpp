#include "where_it_fails/model_state.h"

#include "evaluation/prediction/trial_predictor.h"
#include "foundation/address.h"

#include <limits>

namespace lacuna {
namespace {

std::vector<SensorSpec> joint_sensors(const RobotSpec& robot, SensorKind kind, const std::string& name) {
  std::vector<SensorSpec> sensors;
  for (const JointSpec& joint : robot.joints) {
    if (joint.kind == JointKind::fixed || joint.kind == JointKind::free) continue;  // read by no sensor of a joint
    SensorSpec sensor;
    sensor.name = name + "_" + joint.name;
    sensor.kind = kind;
    sensor.element = joint.name;
    sensors.push_back(sensor);
  }
  return sensors;
}

std::vector<SensorSpec> touch_sensors(const RobotSpec& robot) {
  std::vector<SensorSpec> sensors;
  for (const BodySpec& body : robot.bodies) {
    if (!robot.contact.ground || body.shapes.empty()) continue;
    SensorSpec sensor;
    sensor.name = "state_of_touch_" + body.name;
    sensor.kind = SensorKind::touch;
    sensor.element = body.name;
    sensors.push_back(sensor);
  }
  return sensors;
}

}  // namespace

ModelStates::ModelStates(const ModelDefinition& definition, const Stop& stop) : stop_(stop) {
  ModelStructure structure = definition.structure;
  RobotSpec& robot = structure.robot;
  const auto add = [&](const std::vector<SensorSpec>& sensors) {
    for (const SensorSpec& sensor : sensors) {
      robot.sensors.push_back(sensor);
      for (const Channel& channel : sensor_channels(robot, sensor)) extra_.push_back(channel);
    }
  };
  Eigen::Index coordinate = 0;
  for (const JointSpec& joint : robot.joints)
    for (int c = 0; c < coordinate_count(joint.kind); ++c, ++coordinate)
      if (joint.kind != JointKind::free) read_.push_back(coordinate);
  add(joint_sensors(robot, SensorKind::joint_position, "state_of_position"));
  add(joint_sensors(robot, SensorKind::joint_velocity, "state_of_velocity"));
  add(joint_sensors(robot, SensorKind::joint_force, "state_of_load"));
  const std::vector<SensorSpec> touches = touch_sensors(robot);
  for (const SensorSpec& touch : touches) bodies_.push_back(touch.element);
  add(touches);
  model_ = compile(structure, definition.engine);
}

std::optional<ModelState> ModelStates::of(const Trial& trial, const StartState& start,
                                          const std::vector<double>& values) const {
  Trial wanted = trial;
  wanted.measured.channels = extra_;
  wanted.measured.samples.setZero(trial.measured.times.size(), static_cast<Eigen::Index>(extra_.size()));
  const TrialPredictor predictor(*model_, {std::move(wanted)}, {1, stop_});
  Prediction prediction;
  predictor.predict(predictor.whole(0), values, start, 0, prediction);
  if (!prediction.valid) return std::nullopt;
  return ModelState{of_all_coordinates(prediction.samples, 0), of_all_coordinates(prediction.samples, 1),
                    of_all_coordinates(prediction.samples, 2),
                    prediction.samples.rightCols(static_cast<Eigen::Index>(bodies_.size()))};
}

Eigen::MatrixXd ModelStates::of_all_coordinates(const TimeSeries::Samples& samples, Eigen::Index block) const {
  const auto read = static_cast<Eigen::Index>(read_.size());
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(samples.rows(), static_cast<Eigen::Index>(coordinates().size()));
  for (Eigen::Index i = 0; i < read; ++i) all.col(read_[static_cast<std::size_t>(i)]) = samples.col(block * read + i);
  return all;
}

}  // namespace lacuna
