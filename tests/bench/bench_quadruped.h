#pragma once

#include <lacuna/robot_spec.h>

#include <cstddef>

namespace lacuna {

/// What both loops simulate: the plugin `quadruped` on soft ground, its servos told to walk after a fashion.
RobotSpec bench_quadruped();
inline constexpr double kBenchStep = 0.01;  // s
/// What servo `joint` is told at `time`, of [−1, 1].
double bench_command(std::size_t joint, double time);

}  // namespace lacuna
