#pragma once

#include "search/kept_fits.h"

#include <optional>
#include <string>

namespace lacuna {

/// One JSON document, from which `read_kept_fits` makes the same fits, digit for digit.
std::string kept_fits_json(const KeptFits& fits);

/// Nothing where another version of the program, whose search goes another way, has written it, or a figure of it is
/// not finite.
std::optional<KeptFits> read_kept_fits(const std::string& document);

}  // namespace lacuna
