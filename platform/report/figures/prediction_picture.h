#pragma once

#include "report/figures/figure.h"
#include "report/text/prediction_report.h"

namespace lacuna {

/// A panel a channel: the mean with its band and, where the test was carried out, the readings.
Figure prediction_figure(const PredictionReport& report);

}  // namespace lacuna
