#pragma once

#include "cases/make_case.h"
#include "runs/records.h"

#include <string>
#include <vector>

namespace hidden_effects {

/// How much of a baseline's ranking is kept.
inline constexpr std::size_t kBaselineRanks = 10;

/// What the other methods say of a case, as the database keeps it.
std::vector<BaselineRecord> ask_baselines(const MadeCase& made, const std::vector<std::string>& withheld);

}  // namespace hidden_effects
