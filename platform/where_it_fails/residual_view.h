#pragma once

#include "where_it_fails/where_it_fails.h"

namespace lacuna {

/// The measured channels of the fit trials.
std::vector<Channel> channels_of(const Comparison& comparison);

/// Residuals of free runs at the rows of the table, tested and divided into regimes.
ResidualView free_run_view(const RobotSpec& robot, const Comparison& comparison, const FeatureTable& table,
                           const Work& work);

/// The same for the residual acceleration; without channels where no position or velocity is measured.
ResidualView acceleration_view(const RobotSpec& robot, const Comparison& comparison, const FeatureTable& table,
                               const Work& work);

}  // namespace lacuna
