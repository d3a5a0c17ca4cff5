#pragma once

#include "fitting/fit.h"

#include <string>
#include <vector>

namespace lacuna {

bool has_controller(const std::vector<Trial>& trials);

/// Bias of the model's values due to feedback. Commands of a controller contain its response to disturbances and noise,
/// so values fitted under the recorded commands are biased; values fitted with the controller in the loop of the
/// simulation are not. Fits both ways, where a controller is declared, and returns a sentence per value that differs by
/// more than three standard errors, or one sentence that none does. For a controller that does not reproduce the
/// recorded commands from the recorded readings it returns a sentence that says so, and fits nothing. Throws what `fit`
/// throws.
///
/// Literature: U. Forssell and L. Ljung, "Closed-loop identification revisited", Automatica 35 (1999), 1215-1241.
std::vector<std::string> feedback_bias(const FitTask& task);

}  // namespace lacuna
