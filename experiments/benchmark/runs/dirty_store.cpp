#include "runs/dirty_store.h"

#include "runs/read_results.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace hidden_effects {
namespace {

using nlohmann::ordered_json;

/// `accepted`: JSON list of answers that name it; `parameters`: JSON object.
constexpr const char* kDirtyTable = R"(CREATE TABLE IF NOT EXISTS dirty_effect (
  version TEXT NOT NULL,
  set_name TEXT NOT NULL,
  number INTEGER NOT NULL,
  position INTEGER NOT NULL,     -- from 0
  what TEXT NOT NULL,            -- the law, or 'value body.arm.mass'
  effect TEXT NOT NULL,          -- of the library
  place TEXT NOT NULL,
  role TEXT NOT NULL,            -- 'main', 'small', 'misstated' or 'reading'
  library_form INTEGER NOT NULL, -- 0: the law is not the library's form of the effect
  share REAL,                    -- of the owner's error that it explains
  accepted TEXT NOT NULL,        -- JSON: the answers that name it
  parameters TEXT NOT NULL,      -- JSON
  PRIMARY KEY (version, set_name, number, position),
  FOREIGN KEY (version, set_name, number) REFERENCES bench_case ON DELETE CASCADE
) STRICT)";

std::string json_of_values(const std::vector<NamedValue>& values) {
  ordered_json object = ordered_json::object();
  for (const NamedValue& one : values) object[one.name] = one.value;
  return object.dump();
}

std::vector<DirtyEffectRecord> read_dirty_effects(const Database& database, const Row& key) {
  std::vector<DirtyEffectRecord> effects;
  for (const Row& row :
       database.query("SELECT what, effect, place, role, library_form, share, accepted FROM dirty_effect "
                      "WHERE version = ? AND set_name = ? AND number = ? ORDER BY position",
                      key))
    effects.push_back({text(row[0]),
                       {text(row[1]), text(row[2])},
                       text(row[3]),
                       integer(row[4]) != 0,
                       real(row[5]),
                       ordered_json::parse(text(row[6])).get<std::vector<std::string>>(),
                       {}});
  return effects;
}

}  // namespace

void make_dirty_table(Database& database) { database.execute(kDirtyTable); }

void write_dirty_effects(Database& database, const CaseRecord& about, const std::vector<DirtyEffectRecord>& effects) {
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const DirtyEffectRecord& one = effects[i];
    database.change("INSERT INTO dirty_effect VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
                    {about.version, about.set, std::int64_t{about.number}, static_cast<std::int64_t>(i), one.what,
                     one.answer.effect, one.answer.place, one.role, std::int64_t{one.library_form ? 1 : 0},
                     std::isfinite(one.share) ? Cell(one.share) : Cell(), ordered_json(one.accepted).dump(),
                     json_of_values(one.values)});
  }
}

std::vector<CaseResult> read_dirty_results(const Database& database, const std::string& version,
                                           const std::string& set) {
  std::vector<CaseResult> results;
  for (const Row& row : database.query(
           "SELECT c.number, c.rig, c.strength, c.failure, d.json, d.processor_seconds FROM bench_case c LEFT JOIN "
           "diagnosis d ON d.version = c.version AND d.set_name = c.set_name AND d.number = c.number AND d.round = 1 "
           "WHERE c.version = ? AND c.set_name = ? ORDER BY c.number",
           {version, set})) {
    CaseResult& result = results.emplace_back();
    result.about.version = version;
    result.about.set = set;
    result.about.number = static_cast<int>(integer(row[0]));
    result.about.rig = result.about.group = text(row[1]);
    result.about.strength = real(row[2]);
    result.failure = text(row[3]);
    if (!text(row[4]).empty()) {
      result.diagnoses.push_back(read_diagnosis(text(row[4])));
      result.diagnoses.back().processor_seconds = real(row[5]);
    }
    result.dirty = read_dirty_effects(database, {version, set, row[0]});
  }
  return results;
}

}  // namespace hidden_effects
