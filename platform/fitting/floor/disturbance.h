#pragma once

#include <lacuna/test.h>

#include "config/schema/experiment.h"
#include "evaluation/model/model_definition.h"

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {

/// A joint on which an unmodelled random force acts.
struct DisturbedJoint {
  std::string joint;       ///< name in the robot
  std::string actuator;    ///< the force actuator that exerts it in the disturbed model
  double deviation = 0.0;  ///< N·m or N
};

/// The joints that `noise.process` names, in spec order. Throws `Error` for patterns that name no joint, or
/// one that is neither hinge nor slider.
std::vector<DisturbedJoint> disturbed_joints(const RobotSpec& robot, const NoiseSection& noise);

/// The model with one more force actuator per disturbed joint, through which random forces act.
std::unique_ptr<CompiledModel> compile_disturbed(const ModelDefinition& definition,
                                                 const std::vector<DisturbedJoint>& joints);

/// Commands plus white noise on each sample; channels whose deviation is NaN stay as they are.
CommandSeries with_command_noise(const CommandSeries& commands, std::span<const double> deviations, std::uint64_t seed,
                                 std::uint64_t draw);

/// Commands with one more channel per disturbed joint, from `begin` to `end` (s): a random force drawn every `step` s,
/// independent or of first order with the correlation time. Between draws it behaves like the commands between samples:
/// constant (zero-order hold), or linear to the next draw, which has the same power at low frequencies.
CommandSeries with_random_forces(const CommandSeries& commands, const std::vector<DisturbedJoint>& joints, double step,
                                 double correlation_time, double begin, double end, std::uint64_t seed,
                                 std::uint64_t draw);

/// Commands with one more channel, through which `force` acts during each of the intervals (begin, end; s, ascending,
/// not overlapping) and is zero between them.
CommandSeries with_force_pulses(const CommandSeries& commands, const DisturbedJoint& joint,
                                const std::vector<std::pair<double, double>>& intervals, double force);

}  // namespace lacuna
