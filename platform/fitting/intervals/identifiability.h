#pragma once

#include "fitting/intervals/covariance.h"

#include <string>
#include <vector>

namespace lacuna {

/// A sentence for every combination of values that the data do not determine, such as "the data cannot tell
/// body.arm.mass from actuator.motor.gain (only their ratio)".
std::vector<std::string> undetermined_sentences(const Uncertainty& uncertainty, const FitPoint& point,
                                                const ParameterSpace& space, const std::vector<FreeValue>& free);

}  // namespace lacuna
