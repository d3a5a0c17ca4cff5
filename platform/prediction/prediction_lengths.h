#pragma once

#include "prediction/linear_prediction.h"

#include <vector>

namespace lacuna {

inline constexpr std::size_t kDecidingLengths = 3;  ///< of all lengths, the shortest, which decide first

/// Lengths of prediction, s: five, geometric, from ten samples to the length at which the uncertainty of the initial
/// state is a quarter of the motion's power in one of the joints, at least thirty samples; two where these are less
/// than half as long again as ten. `values`: of the model by which this share is computed. Where no length can be
/// simulated they reach thirty samples.
std::vector<double> prediction_lengths(const LadderSource& source, const ParameterSpace& space,
                                       const std::vector<double>& values);

}  // namespace lacuna
