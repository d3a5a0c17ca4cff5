#pragma once

#include "report/shape_study.h"
#include "storage/eea_store.h"

#include <filesystem>
#include <vector>

namespace lacuna {

/// Reads what replicates of one experiment found of a robot's shape; decodes and judges stored models again where the
/// database has genomes only. Throws `BadInput` where the runs have no objective metric of parts, or cannot be opened.
ShapeStudy read_shape_study(Database& database, const std::vector<EeaRunListing>& runs,
                            const std::vector<std::filesystem::path>& plugin_paths);

}  // namespace lacuna
