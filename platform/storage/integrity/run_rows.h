#pragma once

#include "storage/core/database.h"
#include "storage/core/records.h"

#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// How the rows of a run are told: by a column that has its number, by one whose upper bits have it (row_key.h), or by
/// a condition, for what several runs share: those that the run uses.
enum class RowOwner { number, key, used };

/// A table with rows of runs.
struct TableOfRuns {
  const char* name;
  const char* column;  ///< or the condition, ?1 the run's number
  RowOwner owner;
};

/// All of them, those first that others refer to (passes and their best models refer to each other), but for what
/// changes after a run has ended (`unfinished_diagnosis`, `schema_text`), for `claim`, which ends with it, and for
/// `seal`.
std::span<const TableOfRuns> run_tables();

/// The condition that tells a run's rows: ?1 its number or first key, ?2 its last key.
std::string rows_of_run(const TableOfRuns& table);

struct TableColumns {
  std::vector<std::string> all;
  std::vector<std::string> key;  ///< the primary key, in its order
};

TableColumns columns_of(const Database& database, const std::string& table);

}  // namespace lacuna
