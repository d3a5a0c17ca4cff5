#pragma once

#include "fitting/comparison.h"

#include <string>

namespace lacuna {

/// One line of what a comparison says about the model and what to do next: that trials cannot be simulated, that a
/// floor is not known, that the model is at the floor, or that it is above it and an effect may be missing. What
/// uncertain start states do is no missing effect: the error is compared with the root of floor² + (k · start)², where
/// k, between 2 for one trial and 1 for many, allows for chance. `diagnose`: the command to type then.
std::string advice_text(const Comparison& comparison, const std::string& diagnose);

}  // namespace lacuna
