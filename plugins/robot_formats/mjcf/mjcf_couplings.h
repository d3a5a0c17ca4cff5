#pragma once

#include "mjcf_file.h"

namespace lacuna::mjcf {

/// Two joints that an <equality> ties along a straight line are a coupling, unless one of them follows or leads another
/// way already. The other constraints are named in one remark.
std::vector<CouplingSpec> read_couplings(const Document& document, const DefaultClasses& classes, File& file);

}  // namespace lacuna::mjcf
