#pragma once

#include "report/text/prediction_report.h"

#include <string>

namespace lacuna {

/// A prediction for programs, in SI units.

/// Everything, a line break at its end; numbers that are not known are null.
std::string prediction_json(const PredictionReport& report);

/// "t [s],angle mean [rad],angle lower [rad],angle upper [rad]" and a row a sample, the band as wide as it is told.
std::string prediction_csv(const EnsemblePrediction& prediction);

}  // namespace lacuna
