#pragma once

#include "cases/make_case.h"
#include "runs/records.h"

#include <vector>

namespace hidden_effects {

/// What the true laws, refitted to the fit trials as they were recorded, leave on the held-out ones: RMSE by channel of
/// free runs. As `lacuna compare` scores: where a trial starts is told by its first 50 ms, which do not count. Nothing
/// where the laws cannot be fitted; throws as `simulate` does.
std::vector<HeldOutRecord> truth_held_out(const MadeCase& made);

}  // namespace hidden_effects
