#pragma once

#include "support/robots.h"
#include "support/simulation_run.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace lacuna {

/// The same robot with a body that falls beside it: ODE steps what has a floating body.
inline RobotSpec in_company(RobotSpec robot) {
  BodySpec other = plain_body("other", 1.0, 1.0);
  other.position = Eigen::Vector3d(10.0, 0.0, 0.0);
  robot.bodies.push_back(other);
  return robot;
}

/// Expects that a robot moves as it does where ODE steps it, up to `same` of each reading's largest value. Samples are
/// five integration steps apart.
inline void expect_same_motion(const RobotSpec& robot, const std::function<void(SimulationRun&)>& prepare, double same,
                               int samples) {
  std::vector<double> times;
  for (int i = 0; i <= samples; ++i) times.push_back(0.005 * i);
  SimulationRun alone(robot), together(in_company(robot));
  for (SimulationRun* run : {&alone, &together}) prepare(*run);
  const TimeSeries a = alone.run(times).readings, b = together.run(times).readings;
  for (const Channel& channel : b.channels) {
    const Eigen::VectorXd ours = column(a, channel.name), theirs = column(b, channel.name);
    EXPECT_GT(theirs.cwiseAbs().maxCoeff(), 0.05) << channel.name << " tells nothing";
    EXPECT_LE((ours - theirs).cwiseAbs().maxCoeff(), same * theirs.cwiseAbs().maxCoeff()) << channel.name;
  }
}

}  // namespace lacuna
