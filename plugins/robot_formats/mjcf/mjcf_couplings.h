#pragma once

#include "mjcf_file.h"

namespace lacuna::mjcf {

/// Two joints that an <equality> couples linearly become a coupling, unless one of them already follows or leads in
/// another way. The other constraints are named in one remark.
std::vector<CouplingSpec> read_couplings(const Document& document, const DefaultClasses& classes, File& file);

}  // namespace lacuna::mjcf
