#pragma once

#include "storage/core/database.h"
#include "storage/core/records.h"

namespace lacuna {

/// Whose samples they are.
struct TraceOwner {
  TrialId trial;
  std::optional<ComparisonId> comparison = std::nullopt;  ///< that predicted
  std::optional<ModelId> model = std::nullopt;            ///< that predicted
  TraceKind kind = TraceKind::measured;
};

/// The latest one.
std::optional<TraceId> find_trace(const Database& database, const TraceOwner& owner);

/// In the caller's transaction. Measured series are stored once and found from then on.
TraceId write_trace(const Database& database, RunId run, const TraceOwner& owner, const TimeSeries& series,
                    TracePrecision precision);

/// The settings of the trial's setup, in the order of the file.
std::vector<Setup::Value> read_settings(const Database& database, TrialId trial);

/// Finds the trial by name, digest and whether it is held out, or adds it. In the caller's transaction.
TrialId write_trial(const Database& database, RunId run, ExperimentId experiment, const TrialRecord& record);

}  // namespace lacuna
