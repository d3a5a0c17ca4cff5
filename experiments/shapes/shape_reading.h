#pragma once

#include "app/runs/open_eea_run.h"
#include "shapes/shape_study.h"
#include "storage/eea/eea_store.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace lacuna {

/// Reads what replicates of one experiment found of a robot's shape; decodes and judges stored models again where the
/// database has genomes only. Nothing where the experiment does not speak of parts. Throws `BadInput` where they cannot
/// be opened.
std::optional<ShapeStudy> read_shape_study(Database& database, const std::vector<EeaRunListing>& runs,
                                           const std::vector<std::filesystem::path>& plugin_paths);

}  // namespace lacuna
