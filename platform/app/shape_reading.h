#pragma once

#include "report/shape_study.h"
#include "storage/eea_store.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace lacuna {

/// Reads what replicates of one experiment found of a robot's shape; decodes and judges stored models again where the
/// database has genomes only. Nothing where the runs do not say how far parts are from the target's: without a
/// simulated target, or with another objective metric than `part_distance`. Throws `BadInput` where they cannot be
/// opened.
std::optional<ShapeStudy> read_shape_study(Database& database, const std::vector<EeaRunListing>& runs,
                                           const std::vector<std::filesystem::path>& plugin_paths);

}  // namespace lacuna
