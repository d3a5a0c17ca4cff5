#pragma once

#include "diagnosis/findings/diagnosis.h"
#include "diagnosis/noise/noise_model.h"
#include "diagnosis/refit/folds.h"
#include "diagnosis/refit/refit.h"

#include <vector>

namespace lacuna {

/// RMS of what a refit leaves in each channel, of what it leaves when every fold is predicted from the others, and of
/// the noise.
std::vector<ChannelError> channel_errors(const BaseSolution& base, const RowBins& bins, const NoiseModel& noise,
                                         const Refit& fit, const Folds& folds);

/// Held-out RMS over the floor, all channels together.
double times_floor(const std::vector<ChannelError>& errors);

/// Mean square of what was left out, in units of the noise floor's, less 1: of one channel, and of all together.
double above_floor(const ChannelError& error);
double above_floor(const std::vector<ChannelError>& errors);

}  // namespace lacuna
