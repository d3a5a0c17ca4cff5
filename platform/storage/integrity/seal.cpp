#include "storage/integrity/seal.h"

#include "foundation/processes/stop.h"
#include "foundation/text/json_depth.h"
#include "storage/integrity/row_hash.h"
#include "storage/integrity/run_rows.h"
#include "storage/core/statement.h"

#include <lacuna/error.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <optional>

namespace lacuna {
namespace {

struct Seal {
  std::vector<std::string> columns;
  HashedRows content;
};

/// By table. What cannot be read as a seal has no columns.
std::map<std::string, Seal> seals_of(const Database& database, RunId run) {
  std::map<std::string, Seal> seals;
  Statement row(database, "SELECT part, columns, rows, sha256 FROM seal WHERE run = ?");
  row.with(run);
  while (row.step()) {
    const std::string text = row.text(1);
    const nlohmann::json columns =
        nests_too_deep(text) ? nlohmann::json() : nlohmann::json::parse(text, nullptr, false);
    Seal& seal = seals[row.text(0)];
    seal.content = {row.integer(2), row.text(3)};
    if (columns.is_array() && std::all_of(columns.begin(), columns.end(), [](const auto& c) { return c.is_string(); }))
      seal.columns = columns.get<std::vector<std::string>>();
  }
  return seals;
}

/// Why the rows are not those of the seal; nothing where they are.
std::optional<std::string> fault_of(const Database& database, RunId run, const TableOfRuns& table,
                                    const Seal* seal) try {
  const TableColumns now = columns_of(database, table.name);
  const auto is_known = [&](const std::string& name) {
    return std::find(now.all.begin(), now.all.end(), name) != now.all.end();
  };
  if (seal && (seal->columns.empty() || !std::all_of(seal->columns.begin(), seal->columns.end(), is_known)))
    return "its hash is damaged";
  const HashedRows content = RowHash(database, table, seal ? seal->columns : now.all, now.key).of(run, database.stop());
  const std::int64_t sealed = seal ? seal->content.rows : 0;
  if (content.rows != sealed) return fmt::format("{} rows instead of {}", content.rows, sealed);
  if (seal && content.sha256 != seal->content.sha256) return "different content";
  return std::nullopt;
} catch (const Interrupted&) {
  throw;
} catch (const Error& unreadable) {
  return unreadable.what();
}

void check_run(const Database& database, RunId run, std::map<std::string, Seal> seals, SealCheck& check) {
  for (const TableOfRuns& table : run_tables()) {
    const auto seal = seals.find(table.name);
    if (const auto fault = fault_of(database, run, table, seal == seals.end() ? nullptr : &seal->second))
      check.broken.push_back({run, table.name, *fault});
    if (seal != seals.end()) seals.erase(seal);
  }
  for (const auto& [name, seal] : seals) check.broken.push_back({run, name, "the table is missing"});
}

}  // namespace

struct Sealer::Part {
  Part(const Database& database, const TableOfRuns& table, const TableColumns& of)
      : name(table.name), columns(nlohmann::json(of.all).dump()), rows(database, table, of.all, of.key) {}

  std::string name, columns;
  RowHash rows;
};

Sealer::Sealer(Database& database) : database_(database) {
  for (const TableOfRuns& table : run_tables())
    parts_.push_back(std::make_unique<Part>(database, table, columns_of(database, table.name)));
}

Sealer::~Sealer() = default;

void Sealer::seal(RunId run) {
  unseal_run(database_, run);
  Statement insert(database_, "INSERT INTO seal (run, part, columns, rows, sha256) VALUES (?, ?, ?, ?, ?)");
  for (const auto& part : parts_) {
    const HashedRows content = part->rows.of(run, {});  // interrupted runs are sealed too
    if (content.rows > 0) insert.run_with(run, part->name, part->columns, content.rows, content.sha256);
  }
}

void seal_run(Database& database, RunId run) { Sealer(database).seal(run); }

void unseal_run(Database& database, RunId run) { Statement(database, "DELETE FROM seal WHERE run = ?").run_with(run); }

SealCheck check_seals(const Database& database, const std::function<void(double)>& progress) {
  SealCheck check;
  std::map<std::int64_t, bool> ended;
  Statement runs(database, "SELECT number, ended IS NOT NULL FROM run ORDER BY number");
  while (runs.step()) ended[runs.integer(0)] = runs.flag(1);
  double done = 0.0;
  for (const auto& [number, has_ended] : ended) {
    const RunId run{number};
    std::map<std::string, Seal> seals = seals_of(database, run);
    if (!seals.empty()) {
      check.sealed.push_back(run);
      check_run(database, run, std::move(seals), check);
    } else {
      (has_ended ? check.ended_unsealed : check.not_ended).push_back(run);
    }
    if (progress) progress(++done / static_cast<double>(ended.size()));
  }
  Statement strays(database, "SELECT DISTINCT run FROM seal WHERE run NOT IN (SELECT number FROM run)");
  while (strays.step()) check.broken.push_back({RunId{strays.integer(0)}, "run", "0 rows instead of 1"});
  return check;
}

std::vector<std::string> sealed_tables() {
  std::vector<std::string> names;
  for (const TableOfRuns& table : run_tables()) names.emplace_back(table.name);
  return names;
}

}  // namespace lacuna
