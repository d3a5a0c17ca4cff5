#pragma once

#include <lacuna/engine_settings.h>
#include <lacuna/robot_spec.h>
#include <lacuna/test_encoding.h>
#include <lacuna/trial.h>

#include <vector>

namespace lacuna {

/// What a test of that duration (s) can see and drive on a robot. The limits of an actuator are those in which its
/// command is not clipped, and of a plain force what its force limit asks for; infinite where it declares none.
TestSpace test_space(const RobotSpec& robot, const EngineSettings& engine, double duration);

/// Limits that are not declared become the smallest and the largest command of the trials; infinite where no trial
/// commands the actuator.
void limit_to_trials(TestSpace& space, const std::vector<Trial>& trials);

}  // namespace lacuna
