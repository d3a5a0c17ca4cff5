#pragma once

#include "runs/records.h"

#include <string>
#include <vector>

namespace hidden_effects {

/// Markdown: how the first diagnoses of dirty cases are graded, by how much is needed and by family; beside it an
/// answer that always says the commonest effect; Brier's scores; then a case a row.
std::string dirty_tables(const std::vector<CaseResult>& results);

/// The effects that the first diagnosis names, else its verdict, else why there is none.
std::string answered(const CaseResult& result);

}  // namespace hidden_effects
