#pragma once

#include "report/text/prediction_report.h"

#include <string>

namespace lacuna {

/// A line a channel, what trials that were new to the models say of the band, and what a reader should mind.
std::string prediction_text(const PredictionReport& report);

}  // namespace lacuna
