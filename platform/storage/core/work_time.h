#pragma once

#include "storage/core/database.h"

#include <cstdint>

namespace lacuna {

/// How long a fit or comparison took, in a table of its own: times differ between runs that are
/// otherwise the same. NaN is not stored.
void record_seconds(const Database& database, const char* kind, std::int64_t id, double seconds);
double seconds_of(const Database& database, const char* kind, std::int64_t id);

}  // namespace lacuna
