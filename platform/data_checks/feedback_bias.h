#pragma once

#include "fitting/fit.h"

#include <string>
#include <vector>

namespace lacuna {

bool has_controller(const std::vector<Trial>& trials);

/// What feedback does to the values of a model. Where the commands of the fit trials were made by a declared
/// controller, they hold what it answered to disturbances and noise, and values fitted under these commands are biased
/// by it; with the controller in the loop of the simulation they are not. Fits both ways and gives a sentence a value
/// that differs by more than three standard errors, or one that none does. A controller that does not make the recorded
/// commands of the recorded readings gives a sentence that says so, and nothing is fitted. Throws what `fit` throws.
///
/// Literature: U. Forssell and L. Ljung, "Closed-loop identification revisited", Automatica 35 (1999), 1215-1241.
std::vector<std::string> feedback_bias(const FitTask& task);

}  // namespace lacuna
