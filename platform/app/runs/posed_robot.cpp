#include "app/runs/posed_robot.h"

#include <lacuna/error.h>

#include <fmt/format.h>

namespace lacuna {
namespace {

SensorSpec onlooker(const char* name, SensorKind kind, const BodySpec& body) {
  SensorSpec sensor;
  sensor.name = fmt::format("onlooker_{}_{}", name, body.name);
  sensor.kind = kind;
  sensor.element = body.name;
  return sensor;
}

/// Onlookers stand behind the robot's own sensors, whose channels a controller knows by their order: first those of
/// poses, then those of contacts.
ModelStructure watched(ModelStructure structure) {
  RobotSpec& robot = structure.robot;
  for (const BodySpec& body : robot.bodies) {
    robot.sensors.push_back(onlooker("position", SensorKind::body_position, body));
    robot.sensors.push_back(onlooker("orientation", SensorKind::body_orientation, body));
  }
  if (!robot.contact.ground) return structure;
  for (const BodySpec& body : robot.bodies) robot.sensors.push_back(onlooker("touch", SensorKind::touch, body));
  return structure;
}

}  // namespace

PosedRobot::PosedRobot(const ModelStructure& structure, const EngineSettings& engine, const Stop& stop)
    : model_(compile(watched(structure), engine)), stop_(stop) {
  for (const BodySpec& body : structure.robot.bodies) {
    for (const char* part : {".x", ".y", ".z"}) poses_.push_back({body.name + part, "m"});
    for (const char* part : {".qw", ".qx", ".qy", ".qz"}) poses_.push_back({body.name + part, "1"});
    if (structure.robot.contact.ground) contacts_.push_back({body.name, "1"});
  }
}

PosedRobot::Motion PosedRobot::move(std::span<const double> values, const Test& test,
                                    const std::vector<double>& times) const {
  SimulationOptions options;
  options.stop = stop_;
  options.end_time = times.back();
  options.output_times = times;
  options.start = test.start;
  SimulationResult result;
  const std::unique_ptr<Workspace> workspace = model_->make_workspace();
  model_->simulate(values, test, options, *workspace, result);
  if (result.ending != Ending::completed) throw Error(result.reason);
  const TimeSeries& all = result.readings;
  const auto poses = static_cast<Eigen::Index>(poses_.size()), contacts = static_cast<Eigen::Index>(contacts_.size());
  const Eigen::Index own = all.samples.cols() - poses - contacts;
  Motion motion;
  motion.poses = {poses_, all.times, all.samples.middleCols(own, poses)};
  motion.contacts = {contacts_, all.times, all.samples.rightCols(contacts)};
  motion.readings = {{all.channels.begin(), all.channels.begin() + own}, all.times, all.samples.leftCols(own)};
  return motion;
}

}  // namespace lacuna
