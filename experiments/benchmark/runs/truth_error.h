#pragma once

#include "cases/make_case.h"
#include "runs/records.h"

#include <vector>

namespace hidden_effects {

/// What the true laws, refitted to the fit trials as they were recorded, leave on the held-out ones: RMSE by channel of
/// free runs from rest, where each trial begins, without the first 50 ms, as `lacuna compare` scores. Nothing where
/// they cannot be fitted.
std::vector<HeldOutRecord> truth_held_out(const MadeCase& made);

}  // namespace hidden_effects
