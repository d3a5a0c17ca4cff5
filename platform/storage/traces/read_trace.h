#pragma once

#include "storage/core/database.h"
#include "storage/core/records.h"

namespace lacuna {

/// The samples of a stored trace. Throws `Error` if there is none of that key or its bytes are not
/// those that were written.
TimeSeries read_trace(const Database& database, TraceId trace);

}  // namespace lacuna
