#include "storage/traces/write_trial.h"

#include "storage/core/names.h"
#include "storage/integrity/row_key.h"
#include "storage/traces/trace_codec.h"

namespace lacuna {

std::vector<Setup::Value> read_settings(const Database& database, TrialId trial) {
  Statement row(database, "SELECT address, value FROM trial_setting WHERE trial = ? ORDER BY position");
  row.with(trial);
  std::vector<Setup::Value> values;
  while (row.step()) values.push_back({row.text(0), row.real(1)});
  return values;
}

std::optional<TraceId> find_trace(const Database& database, const TraceOwner& owner) {
  Statement row(database,
                "SELECT id FROM trace WHERE trial = ? AND kind = ? AND comparison IS ? AND model IS ?"
                " ORDER BY id DESC LIMIT 1");
  if (!row.with(owner.trial, to_string(owner.kind), owner.comparison, owner.model).step()) return std::nullopt;
  return TraceId{row.integer(0)};
}

TraceId write_trace(const Database& database, RunId run, const TraceOwner& owner, const TimeSeries& series,
                    TracePrecision precision) {
  if (!owner.comparison && !owner.model && owner.kind != TraceKind::predicted) {
    if (const std::optional<TraceId> there = find_trace(database, owner)) return *there;
  }
  const TraceId id{next_key(database, "trace", run)};
  const EncodedTrace trace = encode_trace(series, precision);
  Statement(database,
            "INSERT INTO trace (id, trial, comparison, model, kind, channels, sample_count, precision, times, samples,"
            " digest) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .run_with(id, owner.trial, owner.comparison, owner.model, to_string(owner.kind), trace.channels,
                trace.sample_count, to_string(precision), std::span<const std::byte>(trace.times),
                std::span<const std::byte>(trace.samples), trace.digest);
  return id;
}

namespace {

/// Whether the settings of a trial belong to a run that has ended: they stay as they are.
bool are_sealed(const Database& database, TrialId trial) {
  Statement seal(database, "SELECT 1 FROM seal WHERE run = ? AND part = 'trial_setting'");
  return seal.with(run_of(trial.value)).step();
}

}  // namespace

TrialId write_trial(const Database& database, RunId run, ExperimentId experiment, const TrialRecord& record) {
  Statement(database,
            "INSERT INTO trial (id, experiment, name, file, digest, held_out, duration, samples, setup)"
            " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT (experiment, digest, name, held_out) DO NOTHING")
      .run_with(next_key(database, "trial", run), experiment, record.name, record.file, record.digest, record.held_out,
                record.duration, record.samples, record.setup.name);
  Statement find(database, "SELECT id FROM trial WHERE experiment = ? AND digest = ? AND name = ? AND held_out = ?");
  find.with(experiment, record.digest, record.name, record.held_out).step();
  const TrialId trial{find.integer(0)};
  if (record.setup.values.empty() || are_sealed(database, trial)) return trial;
  for (std::size_t i = 0; i < record.setup.values.size(); ++i)
    Statement(database,
              "INSERT INTO trial_setting (trial, position, address, value, unit) VALUES (?, ?, ?, ?, ?)"
              " ON CONFLICT (trial, position) DO UPDATE SET unit = excluded.unit WHERE unit = ''")
        .run_with(trial, static_cast<std::int64_t>(i), record.setup.values[i].address, record.setup.values[i].value,
                  i < record.setting_units.size() ? record.setting_units[i] : std::string());
  return trial;
}

}  // namespace lacuna
