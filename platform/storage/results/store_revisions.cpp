#include "storage/results/result_store.h"

#include "storage/core/canonical_text.h"
#include "storage/core/statement.h"
#include "storage/results/revision_change.h"

#include <lacuna/error.h>

namespace lacuna {
namespace {

StoredRevision stored_revision(Statement& row) {
  return {.id = {row.integer(0)},
          .number = row.number(1),
          .parent = row.optional_number(2),
          .digest = row.text(3),
          .change = row.text(4),
          .found = true};
}

constexpr const char* kRevisionByDigest =
    "SELECT r.id, r.number, p.number, r.digest, r.change FROM revision AS r LEFT JOIN revision AS p ON p.id = r.parent"
    " WHERE r.experiment = ? AND r.digest = ?";
constexpr const char* kRevisionByNumber =
    "SELECT r.id, r.number, p.number, r.digest, r.change FROM revision AS r LEFT JOIN revision AS p ON p.id = r.parent"
    " WHERE r.experiment = ? AND r.number = ?";
/// What a former run left without a fit and without a comparison was interrupted or failed, and no model was built on
/// it.
constexpr const char* kRevisionUsedLast =
    "SELECT r.id, r.number, p.number, r.digest, r.change FROM revision_use AS u JOIN revision AS r ON r.id = u.revision"
    " LEFT JOIN revision AS p ON p.id = r.parent WHERE r.experiment = ?"
    " AND (u.run = (SELECT max(number) FROM run) OR EXISTS (SELECT 1 FROM fit WHERE fit.revision = r.id)"
    "      OR EXISTS (SELECT 1 FROM comparison WHERE comparison.revision = r.id))"
    " ORDER BY u.run DESC, u.position DESC LIMIT 1";

}  // namespace

StoredRevision ResultStore::find_or_add_revision(ExperimentId experiment, const RevisionRecord& record) {
  Transaction transaction(database_);
  const std::string digest = digest_of(record);
  std::optional<StoredRevision> stored = find_revision(experiment, digest);
  if (!stored) {
    add_revision(experiment, record, digest);
    stored = find_revision(experiment, digest);
    stored->found = false;
  }
  Statement(database_,
            "INSERT INTO revision_use (run, position, revision)"
            " SELECT ?1, count(*), ?2 FROM revision_use WHERE run = ?1")
      .run_with(run(), stored->id);
  transaction.commit();
  return *stored;
}

void ResultStore::add_revision(ExperimentId experiment, const RevisionRecord& record, const std::string& digest) {
  const std::optional<StoredRevision> parent = current_revision(experiment);
  const RevisionChange change = parent ? change_between(revision_record(parent->id), record) : change_of_first(record);
  Statement(database_,
            "INSERT INTO revision (id, experiment, number, parent, digest, robot, robot_text, free, effects, engine,"
            " fit_data_digest, added, removed, change) SELECT ?1, ?2, coalesce(max(number), 0) + 1, ?3, ?4, ?5, ?6, ?7,"
            " ?8, ?9, ?10, ?11, ?12, ?13 FROM revision WHERE experiment = ?2")
      .run_with(next_id("revision"), experiment, parent ? std::optional(parent->id) : std::nullopt, digest,
                record.robot, record.robot_text, canonical_text(record.free), canonical_text(record.effects),
                canonical_text(record.engine), record.fit_data_digest, canonical_text(change.added),
                canonical_text(change.removed), change.sentence);
}

std::optional<StoredRevision> ResultStore::find_revision(ExperimentId experiment, const std::string& digest) const {
  Statement row(database_, kRevisionByDigest);
  return row.with(experiment, digest).step() ? std::optional(stored_revision(row)) : std::nullopt;
}

std::optional<StoredRevision> ResultStore::find_revision(ExperimentId experiment, const RevisionRecord& record) const {
  return find_revision(experiment, digest_of(record));
}

std::optional<StoredRevision> ResultStore::revision(ExperimentId experiment, int number) const {
  Statement row(database_, kRevisionByNumber);
  return row.with(experiment, number).step() ? std::optional(stored_revision(row)) : std::nullopt;
}

std::optional<StoredRevision> ResultStore::current_revision(ExperimentId experiment) const {
  Statement row(database_, kRevisionUsedLast);
  return row.with(experiment).step() ? std::optional(stored_revision(row)) : std::nullopt;
}

RevisionRecord ResultStore::revision_record(RevisionId revision) const {
  Statement row(database_,
                "SELECT robot, robot_text, free, effects, engine, fit_data_digest FROM revision WHERE id = ?");
  if (!row.with(revision).step()) throw Error(database_.file().string() + ": has no such revision");
  return {.robot = row.text(0),
          .robot_text = row.text(1),
          .free = free_from_text(row.text(2)),
          .effects = effects_from_text(row.text(3)),
          .engine = engine_from_text(row.text(4)),
          .fit_data_digest = row.text(5)};
}

}  // namespace lacuna
