#include "storage/pages/page_candidates.h"

#include "storage/core/statement.h"

#include <fmt/format.h>

#include <string_view>

namespace lacuna {
namespace {

constexpr const char* kBestModels =
    "IN (SELECT best_model FROM pass WHERE best_model IS NOT NULL UNION SELECT model FROM ensemble_model)";
constexpr const char* kBestTests =
    "IN (SELECT best_test FROM pass WHERE best_test IS NOT NULL UNION SELECT test FROM target_trial WHERE test IS NOT "
    "NULL)";

struct CandidateTable {
  std::string_view name;
  std::string_view key;    ///< the column with the model or test
  std::string_view bytes;  ///< of a row, rather more
  const char* best;        ///< condition on the key
};

constexpr CandidateTable kCandidateTables[] = {{"model", "id", "length(genome) + 80", kBestModels},
                                               {"model_score", "model", "35", kBestModels},
                                               {"invalid_model", "model", "length(reason) + 20", kBestModels},
                                               {"test", "id", "length(genome) + 80", kBestTests},
                                               {"test_score", "test", "35", kBestTests},
                                               {"invalid_test", "test", "length(reason) + 20", kBestTests}};
constexpr int kPagesOfTables = 12;  ///< the last page of each table is not full
constexpr int kPageBytes = 4096;

std::int64_t one_number(const Database& database, const std::string& sql) {
  Statement statement(database, sql.c_str());
  return statement.step() ? statement.integer(0) : 0;
}

std::int64_t bytes_where(const Database& database, const CandidateTable& table, const std::string& condition) {
  return one_number(database, fmt::format("SELECT coalesce(sum({}), 0) FROM {} WHERE {} {}", table.bytes, table.name,
                                          table.key, condition));
}

std::int64_t first_key(std::int64_t run) { return run << 40; }

std::int64_t bytes_of_run(const Database& database, std::int64_t run) {
  std::int64_t bytes = 0;
  for (const CandidateTable& table : kCandidateTables)
    bytes += bytes_where(database, table, fmt::format("BETWEEN {} AND {}", first_key(run), first_key(run + 1) - 1));
  return bytes;
}

/// In the order of keys, so that the copy's pages become full.
std::string choice(const CandidateTable& table, std::int64_t first_whole_run) {
  return fmt::format("SELECT * FROM {0} WHERE {1} {2} AND {1} < {3} UNION ALL SELECT * FROM {0} WHERE {1} >= {3}",
                     table.name, table.key, table.best, first_key(first_whole_run));
}

std::string note_of(const Database& database, std::int64_t whole, std::int64_t runs) {
  const std::int64_t models = one_number(database, "SELECT count(*) FROM model"),
                     tests = one_number(database, "SELECT count(*) FROM test");
  if (whole == runs || models + tests == 0) return "";
  const std::string best = "only the best models and tests of each pass are in this report";
  const std::string kept = whole == 0
                               ? "Of all runs, " + best
                               : fmt::format("The newest {} complete. Of the other {}, {}",
                                             whole == 1 ? "run is" : fmt::format("{} runs are", whole),
                                             runs - whole == 1 ? "run" : fmt::format("{} runs", runs - whole), best);
  return fmt::format("{}. All runs together: {} models, {} tests.", kept, models, tests);
}

}  // namespace

bool has_candidates(const std::string& table) {
  for (const CandidateTable& one : kCandidateTables)
    if (one.name == table) return true;
  return false;
}

std::int64_t bytes_of_best_candidates(const Database& database) {
  std::int64_t bytes = kPagesOfTables * kPageBytes;
  for (const CandidateTable& table : kCandidateTables) bytes += bytes_where(database, table, table.best);
  return bytes;
}

CandidateSelection select_candidates(const Database& database, std::int64_t room) {
  CandidateSelection selection;
  selection.first_whole_run = one_number(database, "SELECT coalesce(max(run), 0) + 1 FROM eea_run");
  std::int64_t whole = 0;
  for (Statement run(database, "SELECT run FROM eea_run ORDER BY run DESC"); run.step(); ++whole) {
    room -= bytes_of_run(database, run.integer(0));
    if (room < 0) break;
    selection.first_whole_run = run.integer(0);
  }
  for (const CandidateTable& table : kCandidateTables)
    selection.choices.emplace(table.name, choice(table, selection.first_whole_run));
  selection.note = note_of(database, whole, one_number(database, "SELECT count(*) FROM eea_run"));
  return selection;
}

}  // namespace lacuna
