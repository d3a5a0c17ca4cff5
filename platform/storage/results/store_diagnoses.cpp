#include "storage/core/json_text.h"
#include "storage/core/statement.h"
#include "storage/results/result_store.h"

namespace lacuna {
namespace {

void insert_values(const Database& database, DiagnosisId diagnosis, int rank,
                   const std::vector<CandidateValueRecord>& values) {
  Statement insert(database,
                   "INSERT INTO candidate_value (diagnosis, rank, position, effect, place, name, unit, value, lower,"
                   " upper) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  int position = 0;
  for (const CandidateValueRecord& v : values)
    insert.run_with(diagnosis, rank, position++, v.effect, v.place, v.name, v.unit, v.value, v.lower, v.upper);
}

void insert_candidates(const Database& database, DiagnosisId diagnosis,
                       const std::vector<CandidateRecord>& candidates) {
  Statement insert(database,
                   "INSERT INTO candidate_model (diagnosis, rank, effects, look_alikes, gain, gain_lower, gain_upper,"
                   " times_floor, fitted_times_floor, probability) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  int rank = 0;
  for (const CandidateRecord& c : candidates) {
    insert.run_with(diagnosis, ++rank, sentences_text(c.effects), sentences_text(c.look_alikes), c.gain, c.gain_lower,
                    c.gain_upper, c.times_floor, c.fitted_times_floor, c.probability);
    insert_values(database, diagnosis, rank, c.values);
  }
}

void insert_diagnosis(const Database& database, DiagnosisId id, RevisionId revision, const DiagnosisRecord& d) {
  Statement(
      database,
      "INSERT INTO diagnosis (id, revision, settings, verdict, method, probability, calibrated, chance, hypotheses,"
      " base_times_floor, base_fitted_times_floor, document) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .run_with(id, revision, d.settings, d.verdict, d.method, d.probability, d.calibrated, d.chance, d.hypotheses,
                d.base_times_floor, d.base_fitted_times_floor, d.document);
  insert_candidates(database, id, d.candidates);
}

constexpr const char* kDiagnosedValues = R"(
WITH RECURSIVE origin (id, steps) AS (
  SELECT ?1, 0 UNION ALL SELECT parent, steps + 1 FROM origin JOIN revision USING (id) WHERE parent IS NOT NULL
), named AS (
  SELECT v.diagnosis, v.rank
  FROM candidate_value v JOIN diagnosis d ON d.id = v.diagnosis JOIN origin ON origin.id = d.revision
  WHERE v.effect = ?2 AND v.place = ?3
  ORDER BY origin.steps, d.id DESC, v.rank LIMIT 1
)
SELECT v.name, v.unit, v.value FROM candidate_value v JOIN named USING (diagnosis, rank)
WHERE v.effect = ?2 AND v.place = ?3 AND v.value IS NOT NULL ORDER BY v.position)";

}  // namespace

DiagnosisId ResultStore::record_diagnosis(RevisionId revision, const DiagnosisRecord& d) {
  Transaction transaction(database_);
  Statement made(database_, "SELECT id FROM diagnosis WHERE revision = ? AND settings = ?");
  const bool another_process_was_faster = made.with(revision, d.settings).step();
  const DiagnosisId id{another_process_was_faster ? made.integer(0) : next_id("diagnosis")};
  if (!another_process_was_faster) insert_diagnosis(database_, id, revision, d);
  Statement(database_, "DELETE FROM unfinished_diagnosis WHERE revision = ?").run_with(revision);
  transaction.commit();
  return id;
}

DiagnosisId ResultStore::record_stopped_diagnosis(RevisionId revision, const DiagnosisRecord& d) {
  Transaction transaction(database_);
  const DiagnosisId id{next_id("diagnosis")};
  insert_diagnosis(database_, id, revision, d);
  transaction.commit();
  return id;
}

std::optional<std::string> ResultStore::diagnosis_of(RevisionId revision, const std::string& settings) const {
  Statement row(database_,
                "SELECT document FROM diagnosis WHERE revision = ? AND settings = ? ORDER BY id DESC LIMIT 1");
  if (!row.with(revision, settings).step()) return std::nullopt;
  return row.text(0);
}

std::vector<CandidateValueRecord> ResultStore::diagnosed_values(RevisionId revision, const std::string& effect,
                                                                const std::string& place) const {
  std::vector<CandidateValueRecord> values;
  Statement row(database_, kDiagnosedValues);
  row.with(revision, effect, place);
  while (row.step()) values.push_back({effect, place, row.text(0), row.text(1), row.real(2)});
  return values;
}

std::vector<EffectAtPlace> ResultStore::diagnosed_answer(RevisionId revision) const {
  std::vector<EffectAtPlace> effects;
  Statement row(database_,
                "SELECT value FROM diagnosis JOIN candidate_model ON candidate_model.diagnosis = diagnosis.id,"
                " json_each(candidate_model.effects) WHERE candidate_model.rank = 1 AND verdict = 'effect_found'"
                " AND diagnosis.id = (SELECT max(id) FROM diagnosis WHERE revision = ?)");
  row.with(revision);
  while (row.step()) effects.push_back(effect_at_place_from(row.text(0)));
  return effects;
}

void ResultStore::keep_unfinished_diagnosis(RevisionId revision, const std::string& settings,
                                            const std::string& document) {
  Transaction transaction(database_);
  Statement(database_, "INSERT OR REPLACE INTO unfinished_diagnosis (revision, settings, document) VALUES (?, ?, ?)")
      .run_with(revision, settings, document);
  transaction.commit();
}

std::optional<std::string> ResultStore::unfinished_diagnosis_of(RevisionId revision,
                                                                const std::string& settings) const {
  Statement row(database_, "SELECT document FROM unfinished_diagnosis WHERE revision = ? AND settings = ?");
  if (!row.with(revision, settings).step()) return std::nullopt;
  return row.text(0);
}

}  // namespace lacuna
