#pragma once

#include <lacuna/test.h>
#include <lacuna/trial.h>

#include "evaluation/model/complaints.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace lacuna {

/// The channels of the sensors that match patterns such as `sensor.range*`, in the robot's order, as indices into its
/// channels. Without patterns none. Complains at `key` about patterns that match no sensor.
std::vector<std::size_t> chosen_channels(const RobotSpec& robot, const std::vector<std::string>& patterns,
                                         const std::string& key, Complaints& complaints);

/// A test whose controller gets only these channels of the robot. Tests with commands stay unchanged.
Test with_view(Test test, const std::vector<std::size_t>& channels);

/// The trial with only these measured channels, in the trial's order. Throws `Error` where it measured none of them.
Trial with_channels(Trial trial, const std::vector<std::string>& names);

}  // namespace lacuna
