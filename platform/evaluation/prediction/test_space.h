#pragma once

#include <lacuna/engine_settings.h>
#include <lacuna/robot_spec.h>
#include <lacuna/test_encoding.h>
#include <lacuna/trial.h>

#include <vector>

namespace lacuna {

/// The channels and commands of a test of that duration (s) on a robot. The limits of an actuator are those in which
/// its command is not clipped, and for a plain force those of its force limit; infinite where it declares none.
TestSpace test_space(const RobotSpec& robot, const EngineSettings& engine, double duration);

/// Limits that are not declared become the smallest and the largest command of the trials; infinite where no trial has
/// commands for the actuator.
void limit_to_trials(TestSpace& space, const std::vector<Trial>& trials);

}  // namespace lacuna
