#include "storage/result_store.h"

#include "storage/names.h"
#include "storage/read_trace.h"
#include "storage/statement.h"
#include "storage/trace_codec.h"

#include <lacuna/error.h>

namespace lacuna {

TimeSeries read_trace(const Database& database, TraceId trace) {
  Statement row(database, "SELECT channels, sample_count, precision, times, samples, digest FROM trace WHERE id = ?");
  if (!row.with(trace).step()) throw Error(database.file().string() + ": has no trace " + std::to_string(trace.value));
  return decode_trace({.channels = row.text(0),
                       .sample_count = row.integer(1),
                       .precision = row.text(2) == "float32" ? TracePrecision::float32 : TracePrecision::float64,
                       .times = row.bytes(3),
                       .samples = row.bytes(4),
                       .digest = row.text(5)});
}

TrialId ResultStore::find_or_add_trial(ExperimentId experiment, const TrialRecord& record) {
  Transaction transaction(database_);
  Statement(database_,
            "INSERT INTO trial (id, experiment, name, file, digest, held_out, duration, samples)"
            " VALUES (?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT (experiment, digest, name, held_out) DO NOTHING")
      .run_with(next_id("trial"), experiment, record.name, record.file, record.digest, record.held_out, record.duration,
                record.samples);
  Statement find(database_, "SELECT id FROM trial WHERE experiment = ? AND digest = ? AND name = ? AND held_out = ?");
  find.with(experiment, record.digest, record.name, record.held_out).step();
  const TrialId trial{find.integer(0)};
  transaction.commit();
  return trial;
}

std::vector<StoredTrial> ResultStore::trials(ExperimentId experiment) const {
  Statement row(
      database_,
      "SELECT id, name, file, digest, held_out, duration, samples FROM trial WHERE experiment = ? ORDER BY id");
  row.with(experiment);
  std::vector<StoredTrial> trials;
  while (row.step()) {
    trials.push_back({{row.integer(0)},
                      {.name = row.text(1),
                       .file = row.text(2),
                       .digest = row.text(3),
                       .held_out = row.flag(4),
                       .duration = row.real(5),
                       .samples = row.integer(6)}});
  }
  return trials;
}

TraceId ResultStore::record_trace(TrialId trial, TraceKind kind, const TimeSeries& series, TracePrecision precision,
                                  std::optional<ComparisonId> comparison) {
  Transaction transaction(database_);
  std::optional<TraceId> id = kind == TraceKind::predicted ? std::nullopt : find_trace(trial, kind);
  if (!id) {
    id = TraceId{next_id("trace")};
    const EncodedTrace trace = encode_trace(series, precision);
    Statement(
        database_,
        "INSERT INTO trace (id, trial, comparison, kind, channels, sample_count, precision, times, samples, digest)"
        " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .run_with(*id, trial, comparison, to_string(kind), trace.channels, trace.sample_count, to_string(precision),
                  std::span<const std::byte>(trace.times), std::span<const std::byte>(trace.samples), trace.digest);
  }
  transaction.commit();
  return *id;
}

std::optional<TraceId> ResultStore::find_trace(TrialId trial, TraceKind kind,
                                               std::optional<ComparisonId> comparison) const {
  Statement row(database_,
                "SELECT id FROM trace WHERE trial = ? AND kind = ? AND comparison IS ? ORDER BY id DESC LIMIT 1");
  if (!row.with(trial, to_string(kind), comparison).step()) return std::nullopt;
  return TraceId{row.integer(0)};
}

TimeSeries ResultStore::trace(TraceId trace) const { return read_trace(database_, trace); }

}  // namespace lacuna
