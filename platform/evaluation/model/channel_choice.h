#pragma once

#include <lacuna/test.h>
#include <lacuna/trial.h>

#include "evaluation/model/complaints.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace lacuna {

/// The channels of the sensors that patterns such as `sensor.range*` name, in the robot's order, as indices into its
/// channels. Without patterns none. Complains at `key` about patterns that name no sensor.
std::vector<std::size_t> chosen_channels(const RobotSpec& robot, const std::vector<std::string>& patterns,
                                         const std::string& key, Complaints& complaints);

/// A test whose controller is shown these channels only, of all that a robot has. Commands that were there beforehand
/// see nothing and stay as they are.
Test with_view(Test test, const std::vector<std::size_t>& channels);

/// The trial with the measurements of these channels only, in the trial's order. Throws `Error` where it measured none
/// of them.
Trial with_channels(Trial trial, const std::vector<std::string>& names);

}  // namespace lacuna
