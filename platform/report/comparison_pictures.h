#pragma once

#include "fitting/comparison.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// For every trial and channel one SVG with measured and predicted values and the residual, its
/// floor as a band, below. Returns the files, named `<trial>-<channel>.svg`.
std::vector<std::filesystem::path> draw_comparison(const Comparison& comparison, const std::string& title,
                                                   const std::filesystem::path& folder);

/// The same numbers as CSV, one file a trial: time, then measured, predicted and residual of each channel.
std::vector<std::filesystem::path> write_predictions(const Comparison& comparison, const std::filesystem::path& folder);

}  // namespace lacuna
