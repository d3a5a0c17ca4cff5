#pragma once

#include "answer/diagnosis.h"

#include <string>
#include <vector>

namespace lacuna {

/// A sentence where the answer does not lower the prediction error on the held-out recordings: the RMS over all
/// horizons and channels, each in multiples of its noise floor. Empty where it does, or where no recording is held out.
/// The verdict stays as it is, because held-out recordings have no part in it.
std::string held_out_finding(const std::vector<HorizonError>& errors);

}  // namespace lacuna
