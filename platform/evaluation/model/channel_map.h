#pragma once

#include <lacuna/trial.h>

#include <vector>

namespace lacuna {

/// For each measured channel of the trial, the index of the model's channel with that name. Throws `Error` for a
/// channel that the model does not have, or has in another unit.
std::vector<Eigen::Index> match_channels(const Trial& trial, const std::vector<Channel>& model_channels);

}  // namespace lacuna
