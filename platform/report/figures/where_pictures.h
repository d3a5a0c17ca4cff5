#pragma once

#include "where_it_fails/where_it_fails.h"
#include "report/figures/file_name.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// Draws where a model fails, and returns the files: `where-regimes.svg`, shares of squared error and of samples by
/// regime; for each channel `where-CHANNEL.svg`, the residual against each feature with binned means and their 99 %
/// bands, and `autocorrelation-CHANNEL.svg`. Regimes and features are drawn of each view; those of
/// residual accelerations end in `-acceleration.svg`. At most `kDrawnChannels` channels, those with most error.
/// `names`: of all that the command puts into the folder.
std::vector<std::filesystem::path> draw_where(const WhereItFails& where, const std::string& title,
                                              const std::filesystem::path& folder, FileNames& names,
                                              const Stop& stop = {});

inline constexpr std::size_t kDrawnChannels = 6;

}  // namespace lacuna
