#pragma once

#include "report/figures/figure.h"
#include "report/text/model_prediction.h"

namespace lacuna {

/// A panel a channel of each trial, or of the test: predicted over measured, where there is something measured.
Figure model_prediction_figure(const ModelPrediction& prediction);

}  // namespace lacuna
