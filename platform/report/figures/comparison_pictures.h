#pragma once

#include "fitting/comparison.h"
#include "report/figures/file_name.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// For every trial and channel one SVG with measured and predicted values and the residual, its
/// floor as a band, below. Returns the files, named `<trial>-<channel>.svg`. `names`: of all that the command puts into
/// the folder.
std::vector<std::filesystem::path> draw_comparison(const Comparison& comparison, const std::string& title,
                                                   const std::filesystem::path& folder, FileNames& names,
                                                   const Stop& stop = {});

/// The same numbers as CSV, one file a trial: time, then measured, predicted and residual of each channel.
std::vector<std::filesystem::path> write_predictions(const Comparison& comparison, const std::filesystem::path& folder,
                                                     FileNames& names);

}  // namespace lacuna
