#pragma once

#include <lacuna/time_series.h>

#include "storage/core/records.h"

#include <cstddef>
#include <string>
#include <vector>

namespace lacuna {

/// A time series as bytes. Times: float64 each, or start and step (two float64) where that gives
/// back every time exactly. Samples: row by row, float32 or float64, little-endian; NaN stays NaN.
struct EncodedTrace {
  std::string channels;  ///< JSON: [{"name": ..., "unit": ...}, ...]
  std::int64_t sample_count = 0;
  TracePrecision precision = TracePrecision::float32;
  std::vector<std::byte> times;
  std::vector<std::byte> samples;
  std::string digest;  ///< SHA-256 of all the above, since SQLite does not notice a flipped bit
};

EncodedTrace encode_trace(const TimeSeries& series, TracePrecision precision);
/// Throws `Error` if the bytes are not those that were encoded, or are no series whatever their digest says.
TimeSeries decode_trace(const EncodedTrace& trace);

/// Of all but the digest itself.
std::string digest_of(const EncodedTrace& trace);

std::string to_string(TracePrecision precision);

}  // namespace lacuna
