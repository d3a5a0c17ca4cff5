#pragma once

#include "storage/core/database.h"
#include "storage/core/records.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace lacuna {

class Statement;

/// What the numbers of one database, the shard, become in another that takes its runs in. A run that the other one has
/// already, by its identity, is left out with all that is numbered by it. What runs share (experiments, texts, metrics,
/// trials, revisions) is found by its content, and keeps its key where it is new but for the number of its run.
class Renumbering {
 public:
  Renumbering(const Database& shard, const Database& into);

  /// Runs of the shard with their new numbers, in the order of both.
  const std::map<std::int64_t, std::int64_t>& runs() const { return runs_; }

  std::optional<std::int64_t> run(std::int64_t number) const;
  /// Of what is numbered by its run (row_key.h); nothing where that is left out.
  std::optional<std::int64_t> key(std::int64_t key) const;
  /// Of a row in one of the tables that runs share.
  std::optional<std::int64_t> shared(const std::string& table, std::int64_t key) const;
  /// Of what a row that is copied cannot do without. Throws `Error` where no run of the shard has stored it.
  std::int64_t needed(const std::optional<std::int64_t>& renumbered) const;
  static bool is_shared(const std::string& table);
  /// Whether the other database did not have that row, by the key that it gets.
  bool is_new(const std::string& table, std::int64_t key) const;
  /// The name of a trial that carried a test of one of the runs out, by the key that it gets; null for others.
  const std::string* trial_name(std::int64_t key) const;
  /// The number, within its experiment, of a revision that the other database did not have. `key`: the one that it
  /// gets.
  std::optional<std::int64_t> revision_number(std::int64_t key) const;
  /// The same of a look at held-out data. `experiment`: its new key.
  std::optional<std::int64_t> look_number(std::int64_t experiment, std::int64_t number) const;

 private:
  struct Table {
    std::unordered_map<std::int64_t, std::int64_t> keys;
    std::set<std::int64_t> added;
  };
  void find_runs(const Database& shard, const Database& into);
  void find_tests(const Database& shard);
  void find_rows(const Database& shard, const Database& into, const std::string& table);
  bool give_content(Statement& row, const std::vector<const char*>& columns, Statement& same) const;
  void number_revisions(const Database& shard, const Database& into);
  void number_looks(const Database& shard, const Database& into);

  const std::filesystem::path file_;  ///< the shard, for messages
  std::map<std::int64_t, std::int64_t> runs_;
  std::map<std::string, Table> tables_;
  std::map<std::int64_t, std::string> trial_names_;
  std::map<std::int64_t, std::int64_t> revision_numbers_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> look_numbers_;
};

}  // namespace lacuna
