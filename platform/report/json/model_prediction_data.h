#pragma once

#include "report/text/model_prediction.h"

#include <string>

namespace lacuna {

/// What one model predicts for programs, in SI units.

/// Everything, a line break at its end; numbers that are not known are null.
std::string model_prediction_json(const ModelPrediction& prediction);

/// "trial,t [s],angle predicted [rad],angle measured [rad]" and a row a sample of each trial; of a test "test" and no
/// column of measured values.
std::string model_prediction_csv(const ModelPrediction& prediction);

}  // namespace lacuna
