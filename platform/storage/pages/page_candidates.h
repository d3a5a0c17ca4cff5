#pragma once

#include "storage/core/database.h"

#include <cstdint>
#include <map>
#include <string>

namespace lacuna {

/// Which models and tests of runs a report has where there is no room for all: those that are a pass's best, that stand
/// in an ensemble or that the target carried out, and besides all of the newest runs. For page_copy.h alone.
struct CandidateSelection {
  std::map<std::string, std::string> choices;  ///< a SELECT for each table that has models or tests
  std::int64_t first_whole_run = 0;            ///< runs from this number on are whole
  std::string note;                            ///< a sentence about what is left out; empty: nothing
};

bool has_candidates(const std::string& table);

/// About as many bytes, rather more, as models and tests take that are never left out.
std::int64_t bytes_of_best_candidates(const Database& database);

/// `room`: bytes for models and tests beside those that are never left out.
CandidateSelection select_candidates(const Database& database, std::int64_t room);

}  // namespace lacuna
