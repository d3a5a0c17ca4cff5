#include "app/posed_robot.h"

#include <lacuna/error.h>

namespace lacuna {
namespace {

/// Onlookers stand behind the robot's own sensors, whose channels a controller knows by their order.
ModelStructure watched(ModelStructure structure) {
  for (const BodySpec& body : structure.robot.bodies) {
    SensorSpec place, turn;
    place.name = "onlooker_position_" + body.name;
    place.kind = SensorKind::body_position;
    turn.name = "onlooker_orientation_" + body.name;
    turn.kind = SensorKind::body_orientation;
    place.element = turn.element = body.name;
    structure.robot.sensors.push_back(place);
    structure.robot.sensors.push_back(turn);
  }
  return structure;
}

}  // namespace

PosedRobot::PosedRobot(const ModelStructure& structure, const EngineSettings& engine)
    : model_(compile(watched(structure), engine)) {
  for (const BodySpec& body : structure.robot.bodies) {
    for (const char* part : {".x", ".y", ".z"}) channels_.push_back({body.name + part, "m"});
    for (const char* part : {".qw", ".qx", ".qy", ".qz"}) channels_.push_back({body.name + part, "1"});
  }
}

PosedRobot::Motion PosedRobot::move(std::span<const double> values, const Test& test,
                                    const std::vector<double>& times) const {
  SimulationOptions options;
  options.end_time = times.back();
  options.output_times = times;
  options.start = test.start;
  SimulationResult result;
  const std::unique_ptr<Workspace> workspace = model_->make_workspace();
  model_->simulate(values, test, options, *workspace, result);
  if (result.ending != Ending::completed) throw Error(result.reason);
  const auto poses = static_cast<Eigen::Index>(channels_.size());
  const Eigen::Index own = result.readings.samples.cols() - poses;
  Motion motion;
  motion.poses = {channels_, result.readings.times, result.readings.samples.rightCols(poses)};
  motion.readings = {{result.readings.channels.begin(), result.readings.channels.begin() + own},
                     result.readings.times,
                     result.readings.samples.leftCols(own)};
  return motion;
}

}  // namespace lacuna
