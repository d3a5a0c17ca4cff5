#include "storage/traces/trial_condition.h"

#include "storage/core/canonical_text.h"
#include "storage/core/json_text.h"
#include "storage/core/statement.h"
#include "storage/traces/read_trace.h"
#include "storage/traces/write_trial.h"

#include <lacuna/error.h>

namespace lacuna {
namespace {

constexpr const char* kFirstOrder = "first_order";

/// Rows of knowledge (0: given, 1: from data, 2: free), position, velocity.
Eigen::MatrixXd initial_rows(const Trial& trial) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(trial.initial.size()), 3);
  Eigen::Index row = 0;
  for (const InitialValue& value : trial.initial) {
    rows.row(row++) << static_cast<double>(value.knowledge), value.position, value.velocity;
  }
  return rows;
}

std::vector<InitialValue> initial_from(const Eigen::MatrixXd& rows) {
  std::vector<InitialValue> initial;
  for (const auto& row : rows.rowwise()) {
    initial.push_back({static_cast<InitialKnowledge>(static_cast<int>(row[0])), row[1], row[2]});
  }
  return initial;
}

TimeSeries series_of(const Database& database, TrialId trial, TraceKind kind) {
  const std::optional<TraceId> trace = find_trace(database, {.trial = trial, .kind = kind});
  return trace ? read_trace(database, *trace) : TimeSeries{};
}

}  // namespace

void write_trial_condition(const Database& database, TrialId trial, const Trial& from) {
  Statement(database,
            "INSERT INTO trial_condition (trial, hold, initial, sensor_noise, command_noise, commanded_before)"
            " VALUES (?, ?, ?, ?, ?, ?)"
            " ON CONFLICT (trial) DO NOTHING")
      .run_with(trial, from.commands.hold == Hold::first_order ? kFirstOrder : "zero_order",
                matrix_text(initial_rows(from)), numbers_text(from.sensor_noise), numbers_text(from.command_noise),
                numbers_text(from.commands.before));
}

Trial read_trial(const Database& database, TrialId id) {
  Statement row(database,
                "SELECT name, held_out, digest, hold, initial, sensor_noise, command_noise, commanded_before,"
                " setup FROM trial"
                " JOIN trial_condition ON trial_condition.trial = trial.id WHERE trial.id = ?");
  if (!row.with(id).step()) throw Error(database.file().string() + ": has no trial " + std::to_string(id.value));
  Trial trial;
  trial.name = row.text(0);
  trial.held_out = row.flag(1);
  trial.commands.hold = row.text(3) == kFirstOrder ? Hold::first_order : Hold::zero_order;
  trial.initial = initial_from(matrix_from(row.text(4)));
  trial.sensor_noise = numbers_from(row.text(5));
  trial.command_noise = numbers_from(row.text(6));
  trial.commands.before = numbers_from(row.text(7));
  trial.setup = {row.text(8), read_settings(database, id)};
  trial.measured = series_of(database, id, TraceKind::measured);
  trial.commands.series = series_of(database, id, TraceKind::commands);
  trial.commands.may_be_off = trial.commands.series.samples.hasNaN();
  trial.centre_of_mass = series_of(database, id, TraceKind::centre_of_mass);
  if (digest_of(trial) != row.text(2)) {
    throw Error(database.file().string() + ": trial \"" + trial.name +
                "\" is damaged: it does not match its digest; restore a backup of the database");
  }
  return trial;
}

}  // namespace lacuna
