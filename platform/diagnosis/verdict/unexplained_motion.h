#pragma once

#include "diagnosis/findings/diagnosis.h"
#include "diagnosis/noise/base_solution.h"

#include <string>
#include <vector>

namespace lacuna {

/// A sentence a channel of which the model misses a fifth of the motion in stretches that it is started on anew, or the
/// noise that was found is as large, far more than readings scatter by from sample to sample: a model that is so wrong
/// is not right for want of an effect that explains it, and what is left to it is no noise.
std::vector<std::string> unexplained_motion(const BaseSolution& base, const std::vector<ChannelError>& errors);

/// Of the channel that misses most: its error over the largest that allows a verdict; above 1 it has a sentence.
double missed_motion(const BaseSolution& base, const std::vector<ChannelError>& errors);

}  // namespace lacuna
